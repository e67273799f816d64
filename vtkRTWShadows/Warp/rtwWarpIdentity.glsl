// No warp: a conventional shadow map.
vec2 rtwWarp(int layer, vec2 q)
{
  return q;
}

// Where the centres of a texel and of the next along both axes lie: s, s of the next, t, t of the next.
vec4 rtwTexelCentres(int layer, ivec2 texel)
{
  vec2 first = vec2(texel) + 0.5;
  return vec4(first.x, first.x + 1.0, first.y, first.y + 1.0) / float(rtwWarpSize.y);
}
