// The last frame's focus stays as long as it holds this frame's and is not much larger. One that is outgrown keeps its other end, and grows
// by more than it has to, so that it will stay for long.
layout(local_size_x = 2) in;
layout(std430, binding = 2) buffer Table
{
  vec2 rtwTable[];
};
uniform int rtwOtherLayers;  // how far behind a layer the one is that shares its focus
uniform float rtwMargin;     // room of a new focus on either side, as a share of what is needed
uniform float rtwGrowth;     // room of an outgrown focus, as a share of what is needed
uniform float rtwLeastShare; // share that has to be needed of a focus which stays
const float ROUNDING = 1e-5;

void main()
{
  int layer = int(gl_WorkGroupID.x);
  int axis = int(gl_LocalInvocationID.x);
  int place = rtwWarpPlace(4 * layer + axis, rtwWarpSize.x);
  float extent = 1.0 / rtwTable[place].y;
  vec2 needed = rtwTable[place].x + vec2(0.0, extent);
  vec2 ends = needed + vec2(-rtwMargin, rtwMargin) * extent;
  vec2 focus = vec2(ends.x, 1.0 / (ends.y - ends.x));
  if (rtwIsKnown(layer))
  {
    vec2 last = rtwLastFocus(layer, axis);
    vec2 lastEnds = last.x + vec2(0.0, 1.0 / last.y);
    vec2 outgrown = vec2(lastEnds.x - needed.x, needed.y - lastEnds.y);
    if (extent >= rtwLeastShare * (lastEnds.y - lastEnds.x))
    {
      ends = mix(lastEnds, needed + vec2(-rtwGrowth, rtwGrowth) * extent, greaterThan(outgrown, vec2(ROUNDING * extent)));
      focus = ends == lastEnds ? last : vec2(ends.x, 1.0 / (ends.y - ends.x));
    }
  }
  rtwTable[place] = focus;
  rtwTable[rtwWarpPlace(4 * (layer + rtwOtherLayers) + axis, rtwWarpSize.x)] = focus;
}
