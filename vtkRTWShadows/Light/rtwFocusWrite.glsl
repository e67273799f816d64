// Puts the reduced bounds into the warp table; the light's own bounds where no sample is lit.
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Bounds
{
  uint rtwBounds[];
};
layout(std430, binding = 1) writeonly buffer Table
{
  vec2 rtwTable[];
};
uniform int rtwLayer;
uniform vec4 rtwWholeBounds;
uniform float rtwMargin; // a share of the extent

float rtwUnordered(uint bits)
{
  return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}

void main()
{
  vec4 found = vec4(rtwUnordered(rtwBounds[4 * rtwLayer]), rtwUnordered(rtwBounds[4 * rtwLayer + 1]),
    rtwUnordered(rtwBounds[4 * rtwLayer + 2]), rtwUnordered(rtwBounds[4 * rtwLayer + 3]));
  bool any = rtwBounds[4 * rtwLayer] != 0xffffffffu && all(lessThanEqual(found.xy, found.zw));
  vec4 bounds = any ? found : rtwWholeBounds;
  vec2 margin = rtwMargin * (bounds.zw - bounds.xy) + 1e-6 * (rtwWholeBounds.zw - rtwWholeBounds.xy);
  vec2 low = bounds.xy - margin;
  vec2 scale = 1.0 / (bounds.zw + margin - low);
  rtwTable[rtwWarpPlace(4 * rtwLayer, rtwWarpSize.x)] = vec2(low.x, scale.x);
  rtwTable[rtwWarpPlace(4 * rtwLayer + 1, rtwWarpSize.x)] = vec2(low.y, scale.y);
}
