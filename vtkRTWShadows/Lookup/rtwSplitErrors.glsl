// The error that maps would have with their texels divided otherwise between s and t, predicted from listed shadow
// edges: by how many pixels these move that are off by a texel. A work group a ratio; lights one after another.
layout(local_size_x = 256) in;
const int GROUP = 256;
const float WIDEST = 50.0; // pixels that an edge can move by at most

layout(std430, binding = 0) readonly buffer Samples
{
  uint rtwCount;
  uint rtwEdgeCount;
  vec4 rtwListed[]; // as rtwTurnSamples.glsl has them
};
layout(std430, binding = 1) buffer Errors
{
  float rtwErrors[];
};
uniform vec2 rtwTexelSizes[RTW_SPLITS]; // sizes of a map's texel along s and t, for each ratio
uniform int rtwSlots;
uniform int rtwFirstLayer; // the light's first layer
uniform int rtwParts;      // layers of the light
uniform vec4 rtwBeam;
shared float rtwPartial[GROUP];

float rtwErrorOf(int edge)
{
  int place = 2 * rtwSlots + 3 * edge;
  vec4 a = rtwListed[place];
  vec4 b = rtwListed[place + 1];
  vec4 c = rtwListed[place + 2];
  int layer = rtwLayerAt(rtwFirstLayer, rtwParts, c.yzw, rtwBeam);
  vec4 focus = rtwFocus(layer);
  mat2 slope = rtwWarpSlope(layer, rtwFocused(focus, a.xy));
  float moved = rtwMisplaced(slope * (a.zw * focus.yw), slope * (b.xy * focus.yw), b.zw, rtwTexelSizes[gl_WorkGroupID.x]);
  return c.x * (moved < WIDEST ? moved : WIDEST);
}

void main()
{
  int me = int(gl_LocalInvocationIndex);
  int edges = int(min(rtwEdgeCount, uint(rtwSlots)));
  float mine = 0.0;
  for (int i = me; i < edges; i += GROUP)
  {
    mine += rtwErrorOf(i);
  }
  rtwPartial[me] = mine;
  barrier();
  for (int step = GROUP / 2; step > 0; step /= 2)
  {
    if (me < step)
    {
      rtwPartial[me] += rtwPartial[me + step];
    }
    barrier();
  }
  if (me == 0)
  {
    rtwErrors[gl_WorkGroupID.x] += rtwPartial[0];
  }
}
