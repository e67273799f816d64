// Puts the reduced bounds into the warp table; the light's own bounds where no sample is lit.
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Bounds
{
  uint rtwBounds[];
};
layout(rg32f, binding = 0) writeonly uniform image2D rtwTable;
uniform int rtwLayer;
uniform int rtwCells;
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
  imageStore(rtwTable, ivec2(rtwCells, 4 * rtwLayer), vec4(low.x, scale.x, 0.0, 0.0));
  imageStore(rtwTable, ivec2(rtwCells, 4 * rtwLayer + 1), vec4(low.y, scale.y, 0.0, 0.0));
}
