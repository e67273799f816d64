// The bounds that a layer has to hold, as they grow.
layout(std430, binding = 0) buffer Bounds
{
  uint rtwBounds[]; // a layer: low s, low t, high s, high t, as rtwOrdered() has them; then those of the second pass
};
uniform int rtwLayer;
uniform float rtwFilterWidth; // how far in the world a filter looks around a receiver
uniform vec4 rtwWholeBounds;  // nothing outside the light's own bounds counts

vec4 rtwUnited(vec4 a, vec4 b)
{
  return vec4(min(a.xy, b.xy), max(a.zw, b.zw));
}

vec4 rtwAround(vec2 centre, vec2 reach)
{
  return vec4(centre - reach, centre + reach);
}

vec4 rtwKept(vec4 found)
{
  return vec4(max(found.xy, rtwWholeBounds.xy), min(found.zw, rtwWholeBounds.zw));
}

void rtwAddBounds(vec4 found, int pass)
{
  int first = 8 * rtwLayer + 4 * pass;
  atomicMin(rtwBounds[first], rtwOrdered(found.x));
  atomicMin(rtwBounds[first + 1], rtwOrdered(found.y));
  atomicMax(rtwBounds[first + 2], rtwOrdered(found.z));
  atomicMax(rtwBounds[first + 3], rtwOrdered(found.w));
}
