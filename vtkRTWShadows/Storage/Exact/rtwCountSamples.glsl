// What each pixel shows, as the light sees it, and how many samples fall on each texel.
//
// Depth is signed distance along a directional light, from where view coordinates begin, and r - r²/w under a spot, w being the distance
// along its axis and r that of what is seen: both linear over a plane, and as precise as floats are there. A sample is put nearer to the
// light by as much as roundings can be, so that the triangle that it lies on, and that one's neighbours at their common edge, are not in
// front of it.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) writeonly buffer Found
{
  vec4 rtwFound[]; // for each sample: light-plane coordinates and depth, and its normal
};
layout(std430, binding = 1) writeonly buffer Places
{
  // For each sample: its texel, and its place among the texel's samples; NOWHERE where it doesn't face the light.
  uvec2 rtwPlaces[];
};
layout(std430, binding = 2) writeonly buffer States
{
  uint rtwStates[]; // for each pixel, the state of rtwExactState.glsl
};
uniform int rtwLayer;
uniform mat4 rtwViewToPlane; // from view coordinates to (l · w, depth · w, w)
uniform vec4 rtwCone;        // a spot's: centre, tangent; tangent 0 for a directional light
// tolerances: a length along the light; a length across it; and across it a share of the distance from where view
// coordinates begin
uniform vec3 rtwTolerance;
uniform float rtwReference;  // r; 0 for a directional light
uniform int rtwSamplesAPixel;
uniform vec2 rtwOffsets[8]; // places of a pixel's samples from its centre, in pixels

const uint NOWHERE = 0xffffffffu;

vec4 rtwOnPlane(vec3 p)
{
  vec4 h = rtwViewToPlane * vec4(p, 1.0);
  return vec4(h.xyz / h.w, h.w);
}

// Places a point of a pixel on the grid; true where its surface faces the light.
bool rtwPlace(ivec2 pixel, int point, uint place)
{
  SampledPlane plane = rtwPlaneAt(rtwSampleOf(pixel, point), pixel, rtwOffsets[point]);
  vec4 here = rtwOnPlane(plane.here);
  vec3 dx = rtwOnPlane(plane.right).xyz - here.xyz;
  vec3 dy = rtwOnPlane(plane.above).xyz - here.xyz;
  float area = dx.x * dy.y - dx.y * dy.x;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back.
  bool faces = plane.seen && area < 0.0 && here.w > 0.0 && (rtwCone.z == 0.0 || distance(here.xy, rtwCone.xy) <= rtwCone.z);
  if (!faces)
  {
    rtwPlaces[place] = uvec2(NOWHERE);
    return false;
  }
  vec2 gradient = vec2(dx.z * dy.y - dy.z * dx.y, dx.x * dy.z - dy.x * dx.z) / area;
  float across = (rtwTolerance.y + rtwTolerance.z * length(plane.here)) / here.w;
  across *= rtwCone.z == 0.0 ? 1.0 : 1.0 + distance(here.xy, rtwCone.xy);
  // The depth that a length of 1 along the light amounts to.
  float rate = rtwReference > 0.0 ? rtwReference / here.w * (rtwReference / here.w) : 1.0;
  float depth = here.z - rtwTolerance.x * rate - across * (abs(gradient.x) + abs(gradient.y));
  vec2 onMap = rtwWarp(rtwLayer, rtwFocused(rtwFocus(rtwLayer), here.xy));
  uint texel = rtwTexelAt(onMap);
  rtwFound[place] = vec4(here.xy, depth, rtwPackNormal(normalize(vec3(-gradient / (here.w * rate), 1.0))));
  rtwPlaces[place] = uvec2(texel, atomicAdd(rtwNodes[texel].count, 1u));
  return true;
}

void main()
{
  ivec2 size = textureSize(rtwSamples, 0);
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, size)))
  {
    return;
  }
  uint at = uint(pixel.y * size.x + pixel.x);
  uint state = 0u;
  for (int point = 0; point < rtwSamplesAPixel; ++point)
  {
    bool faces = rtwPlace(pixel, point, at * uint(rtwSamplesAPixel) + uint(point));
    state |= faces ? 1u << (STATE_FACES + uint(point)) : 0u;
  }
  rtwStates[at] = state;
}
