// The bounds on the light plane of all view samples that the light can reach: the desired view (Rosen 2012, section 5.1; Milet
// et al. 2015, section 3.3), by parallel reduction.
layout(local_size_x = 16, local_size_y = 16) in;

layout(std430, binding = 0) buffer Bounds
{
  uint rtwBounds[]; // a layer: low s, low t, high s, high t; in an order that unsigned numbers share
};
uniform int rtwLayer;
uniform float rtwFilterWidth; // how far in the world a filter looks around a receiver
uniform vec4 rtwWholeBounds; // nothing outside the light's own bounds counts
shared vec4 rtwPartial[256];

uint rtwOrdered(float x)
{
  uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

vec4 rtwSeen = vec4(1e30, 1e30, -1e30, -1e30); // by this invocation

// It speaks for the pixels around it too.
void rtwVisit(LitSample s)
{
  vec2 reach = s.reach + rtwFilterWidth / s.w;
  rtwSeen = vec4(min(rtwSeen.xy, s.onLight - reach), max(rtwSeen.zw, s.onLight + reach));
}

void main()
{
  rtwVisitTile();
  uint me = gl_LocalInvocationIndex;
  rtwPartial[me] = rtwSeen;
  barrier();
  for (uint step = 128u; step > 0u; step /= 2u)
  {
    if (me < step)
    {
      vec4 other = rtwPartial[me + step];
      rtwPartial[me] = vec4(min(rtwPartial[me].xy, other.xy), max(rtwPartial[me].zw, other.zw));
    }
    barrier();
  }
  if (me == 0u && rtwPartial[0].x <= rtwPartial[0].z)
  {
    vec4 found = vec4(max(rtwPartial[0].xy, rtwWholeBounds.xy), min(rtwPartial[0].zw, rtwWholeBounds.zw));
    atomicMin(rtwBounds[4 * rtwLayer], rtwOrdered(found.x));
    atomicMin(rtwBounds[4 * rtwLayer + 1], rtwOrdered(found.y));
    atomicMax(rtwBounds[4 * rtwLayer + 2], rtwOrdered(found.z));
    atomicMax(rtwBounds[4 * rtwLayer + 3], rtwOrdered(found.w));
  }
}
