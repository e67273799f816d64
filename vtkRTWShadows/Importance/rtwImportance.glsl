// What the view samples ask for along each axis of the light plane, collapsed to one value a column and one a row.
//
// Published (Rosen 2012, sections 4.2 and 5): the product of the chosen functions, the largest in a column counts. √demand: the
// sum of one over the footprint, because a shadow edge that is a texel off costs a pixel that share; its square root
// is taken where the warping map is built.
layout(local_size_x = 16, local_size_y = 16) in;
const int TILE = 64;
const int MOST_CELLS = 2048;
const int DISTANCE_TO_EYE = 2;
const int SURFACE_NORMAL = 4;
const int SQRT_DEMAND = 8;
const float LARGEST = 1048575.0; // 4096 samples of a tile that all ask for so much don't overflow a sum

layout(std430, binding = 0) buffer Profile
{
  uint rtwProfile[]; // a layer, an axis, a cell: low and high part of a sum, or the bits of a maximum
};
uniform int rtwLayer;
uniform int rtwFunctions;
uniform float rtwNearest; // distance that has the importance 1
uniform float rtwBeta;    // bonus of a surface that is seen head on
shared uint rtwTile[2 * MOST_CELLS];

float rtwFunction(LitSample s)
{
  float value = 1.0;
  if ((rtwFunctions & DISTANCE_TO_EYE) != 0 && rtwParallelView.x == 0.0)
  {
    value *= rtwNearest / max(-s.position.z, 1e-30);
  }
  if ((rtwFunctions & SURFACE_NORMAL) != 0)
  {
    value *= 1.0 + rtwBeta * clamp(s.normal.z, 0.0, 1.0);
  }
  return value;
}

void rtwAddSample(LitSample s, vec4 focus)
{
  ivec2 cell = clamp(ivec2(rtwFocused(focus, s.onLight) * float(rtwWarpSize.x)), 0, rtwWarpSize.x - 1);
  float value = rtwFunction(s);
  if ((rtwFunctions & SQRT_DEMAND) != 0)
  {
    vec2 demand = clamp(value / max(s.footprint * focus.yw, 1e-30), 1.0, LARGEST);
    atomicAdd(rtwTile[cell.x], uint(demand.x + 0.5));
    atomicAdd(rtwTile[MOST_CELLS + cell.y], uint(demand.y + 0.5));
  }
  else
  {
    atomicMax(rtwTile[cell.x], floatBitsToUint(value));
    atomicMax(rtwTile[MOST_CELLS + cell.y], floatBitsToUint(value));
  }
}

void main()
{
  uint me = gl_LocalInvocationIndex;
  for (uint i = me; i < uint(2 * MOST_CELLS); i += 256u)
  {
    rtwTile[i] = 0u;
  }
  barrier();
  vec4 focus = rtwFocus(rtwLayer);
  ivec2 size = rtwNumberOfSamples();
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * TILE + ivec2(gl_LocalInvocationID.xy);
  for (int y = 0; y < TILE; y += 16)
  {
    for (int x = 0; x < TILE; x += 16)
    {
      ivec2 pixel = corner + ivec2(x, y);
      if (all(lessThan(pixel, size)))
      {
        LitSample s = rtwLoadSample(pixel);
        if (s.used)
        {
          rtwAddSample(s, focus);
        }
      }
    }
  }
  barrier();
  for (uint i = me; i < uint(2 * rtwWarpSize.x); i += 256u)
  {
    uint axis = i < uint(rtwWarpSize.x) ? 0u : 1u;
    uint value = rtwTile[axis * uint(MOST_CELLS) + i - axis * uint(rtwWarpSize.x)];
    uint at = 2u * (uint(2 * rtwLayer * rtwWarpSize.x) + i);
    if (value == 0u)
    {
      continue;
    }
    if ((rtwFunctions & SQRT_DEMAND) == 0)
    {
      atomicMax(rtwProfile[at], value);
    }
    else if (atomicAdd(rtwProfile[at], value) > 0xffffffffu - value)
    {
      atomicAdd(rtwProfile[at + 1u], 1u); // the carry
    }
  }
}
