// The bounds that a layer has to hold, as they grow.
layout(std430, binding = 0) buffer Bounds
{
  uint rtwBounds[]; // for each layer: low s, low t, high s, high t, by rtwOrdered(); then the same for the second pass
};
uniform int rtwLayer; // the first layer at work
uniform float rtwFilterWidth; // how far in the world a filter looks around a receiver
uniform vec4 rtwWholeBounds;  // the light's own bounds, outside of which nothing counts

const vec4 NOTHING = vec4(1e30, 1e30, -1e30, -1e30);

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

void rtwAddBounds(int layer, vec4 found, int pass)
{
  int first = 8 * layer + 4 * pass;
  atomicMin(rtwBounds[first], rtwOrdered(found.x));
  atomicMin(rtwBounds[first + 1], rtwOrdered(found.y));
  atomicMax(rtwBounds[first + 2], rtwOrdered(found.z));
  atomicMax(rtwBounds[first + 3], rtwOrdered(found.w));
}

// Whether the bounds of a layer's samples from the first pass hold all of `maybe`.
bool rtwIsSettled(int layer, vec4 maybe)
{
  int first = 8 * layer;
  return maybe.x > maybe.z ||
    (rtwOrdered(maybe.x) >= rtwBounds[first] && rtwOrdered(maybe.y) >= rtwBounds[first + 1] &&
      rtwOrdered(maybe.z) <= rtwBounds[first + 2] && rtwOrdered(maybe.w) <= rtwBounds[first + 3]);
}
