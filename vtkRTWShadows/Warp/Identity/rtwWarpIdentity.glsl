// No warp: a conventional shadow map.
vec2 rtwWarp(int layer, vec2 q)
{
  return q;
}

vec3 rtwWarpHomogeneous(int layer, vec2 q)
{
  return vec3(rtwWarp(layer, q), 1.0);
}

vec2 rtwTexelCentre(int layer, ivec2 texel)
{
  return (vec2(texel) + 0.5) / float(rtwWarpSize.y);
}

TexelCentres rtwTexelCentres(int layer, ivec2 texel)
{
  vec2 here = rtwTexelCentre(layer, texel);
  vec2 next = here + 1.0 / float(rtwWarpSize.y);
  return TexelCentres(here, vec2(next.x, here.y), vec2(here.x, next.y), next);
}
