// The decisions of neighbouring texels become one: 1 lit, 0 in shadow.
float rtwNearest(int layer, rtwReceiver r)
{
  ivec2 last = rtwMapSize - 1;
  vec2 at = rtwWarp(layer, r.q.xy) * vec2(rtwMapSize);
  ivec2 texel = clamp(ivec2(floor(at)), ivec2(0), last);
  vec2 centre = rtwTexelCentre(layer, texel);
  return 1.0 - rtwOccluded(layer, texel, centre, r, rtwSlope(layer, texel), 0.0);
}

float rtwBilinear(int layer, rtwReceiver r)
{
  ivec2 last = rtwMapSize - 1;
  vec2 at = rtwWarp(layer, r.q.xy) * vec2(rtwMapSize);
  ivec2 corner = clamp(ivec2(floor(at - 0.5)), ivec2(0), last - 1);
  ivec2 right = corner + ivec2(1, 0);
  ivec2 above = corner + ivec2(0, 1);
  vec2 f = clamp(at - 0.5 - vec2(corner), 0.0, 1.0);
  TexelCentres c = rtwTexelCentres(layer, corner);
  vec2 a = rtwSlope(layer, corner);
  vec2 b = rtwSlope(layer, right);
  vec2 d = rtwSlope(layer, above);
  vec2 e = rtwSlope(layer, corner + 1);
  // Where no two neighbouring texels hold the same triangle, the surface is rough beside texels.
  float rough = a != b && a != d && e != b && e != d ? RTW_ROUGHNESS : 0.0;
  vec4 dark = vec4(rtwOccluded(layer, corner, c.here, r, a, rough),
    rtwOccluded(layer, right, c.right, r, b, rough), rtwOccluded(layer, above, c.above, r, d, rough),
    rtwOccluded(layer, corner + 1, c.beyond, r, e, rough));
  vec2 rows = mix(dark.xz, dark.yw, f.x);
  return 1.0 - mix(rows.x, rows.y, f.y);
}
