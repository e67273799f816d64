// Perspective warp (Lloyd et al. 2006, section 4.1): t goes along the view on the light plane, and the map is as wide across as the view is
// there. A homography, so that straight lines stay straight.
//
// In the table: in the row of s, the map's two ends along s where t is 0; in that of t, (f' - n') / n', which is 0 where there is no warp, and
// the s of the line on which all lines along t meet.
vec4 rtwPerspective(int layer)
{
  return vec4(rtwWarpEntry(4 * layer, 0), rtwWarpEntry(4 * layer + 1, 0));
}

// Homogeneous map coordinates; the third is the paper's z' in units of n', which is negative behind the centre of
// projection.
vec3 rtwWarpHomogeneous(int layer, vec2 q)
{
  vec4 p = rtwPerspective(layer);
  float h = 1.0 + p.z * q.y;
  return vec3((q.x - p.w + (p.w - p.x) * h) / (p.y - p.x), (1.0 + p.z) * q.y, h);
}

vec2 rtwWarp(int layer, vec2 q)
{
  vec3 u = rtwWarpHomogeneous(layer, q);
  return u.xy / u.z;
}

// The s of a column of the map where t is 0, and the t and z' of a row, computed from terms that are all positive, so
// that nothing cancels out.
float rtwColumnOf(vec4 p, int texel)
{
  return mix(p.x, p.y, (float(texel) + 0.5) / float(rtwMapSize.x));
}

vec2 rtwRowOf(vec4 p, int texel)
{
  float side = float(rtwMapSize.y);
  float scale = 1.0 / (1.0 + p.z * (side - float(texel) - 0.5) / side);
  return vec2((float(texel) + 0.5) / side, 1.0 + p.z) * scale;
}

vec2 rtwTexelPlace(vec4 p, float column, vec2 row)
{
  return vec2(p.w + row.y * (column - p.w), row.x);
}

vec2 rtwTexelCentre(int layer, ivec2 texel)
{
  vec4 p = rtwPerspective(layer);
  return rtwTexelPlace(p, rtwColumnOf(p, texel.x), rtwRowOf(p, texel.y));
}

TexelCentres rtwTexelCentres(int layer, ivec2 texel)
{
  vec4 p = rtwPerspective(layer);
  float here = rtwColumnOf(p, texel.x);
  float right = rtwColumnOf(p, texel.x + 1);
  vec2 row = rtwRowOf(p, texel.y);
  vec2 above = rtwRowOf(p, texel.y + 1);
  return TexelCentres(rtwTexelPlace(p, here, row), rtwTexelPlace(p, right, row), rtwTexelPlace(p, here, above),
    rtwTexelPlace(p, right, above));
}
