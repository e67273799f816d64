// Rectilinear texture warping (Rosen 2012, section 3): a monotone function of each axis, linear in each cell, and
// with the slope of its last cells beyond the ends, so that what crosses an end isn't bent there.
float rtwWarpAlong(int row, float x)
{
  float f = x * float(rtwWarpSize.x);
  int cell = clamp(int(floor(f)), 0, rtwWarpSize.x - 1);
  vec2 ends = rtwWarpEntry(row, cell);
  return ends.x + (f - float(cell)) * (ends.y - ends.x);
}

vec2 rtwWarp(int layer, vec2 q)
{
  return vec2(rtwWarpAlong(4 * layer, q.x), rtwWarpAlong(4 * layer + 1, q.y));
}

vec3 rtwWarpHomogeneous(int layer, vec2 q)
{
  return vec3(rtwWarp(layer, q), 1.0);
}

vec2 rtwTexelCentre(int layer, ivec2 texel)
{
  return vec2(rtwWarpEntry(4 * layer + 2, texel.x).x, rtwWarpEntry(4 * layer + 3, texel.y).x);
}

TexelCentres rtwTexelCentres(int layer, ivec2 texel)
{
  vec2 s = rtwWarpEntry(4 * layer + 2, texel.x);
  vec2 t = rtwWarpEntry(4 * layer + 3, texel.y);
  return TexelCentres(vec2(s.x, t.x), vec2(s.y, t.x), vec2(s.x, t.y), vec2(s.y, t.y));
}
