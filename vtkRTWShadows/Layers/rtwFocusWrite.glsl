// Puts the reduced bounds into the warp table as the focus. A layer in which no sample is lit gets the light's own
// bounds or, if other layers may have samples, a place beside those bounds, so that nothing is drawn.
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
uniform float rtwMargin; // a share of the focus' extent
uniform int rtwParts;    // layers of the light

void main()
{
  int first = 8 * rtwLayer;
  uvec4 ordered;
  for (int k = 0; k < 2; ++k)
  {
    ordered[k] = min(rtwBounds[first + k], rtwBounds[first + 4 + k]);
    ordered[2 + k] = max(rtwBounds[first + 2 + k], rtwBounds[first + 6 + k]);
  }
  vec4 found = vec4(rtwUnordered(ordered.x), rtwUnordered(ordered.y), rtwUnordered(ordered.z), rtwUnordered(ordered.w));
  bool any = ordered.x != 0xffffffffu && all(lessThanEqual(found.xy, found.zw));
  vec4 none = rtwParts == 1 ? rtwWholeBounds : rtwWholeBounds + 2.0 * (rtwWholeBounds.zw - rtwWholeBounds.xy).xyxy;
  vec4 bounds = any ? found : none;
  vec2 margin = rtwMargin * (bounds.zw - bounds.xy) + 1e-6 * (rtwWholeBounds.zw - rtwWholeBounds.xy);
  vec2 low = bounds.xy - margin;
  vec2 scale = 1.0 / (bounds.zw + margin - low);
  rtwTable[rtwWarpPlace(4 * rtwLayer, rtwWarpSize.x)] = vec2(low.x, scale.x);
  rtwTable[rtwWarpPlace(4 * rtwLayer + 1, rtwWarpSize.x)] = vec2(low.y, scale.y);
}
