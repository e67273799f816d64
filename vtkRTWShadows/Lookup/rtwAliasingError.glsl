// The aliasing error m = w'_l / w'_i: how wide a texel is on a surface, beside a pixel (Lloyd et al. 2006, equation 1, the exact form).
// A pixel is as wide along s and t as the ellipse that its round beam becomes on the map, where a texel is 1 wide.

// The extent of that ellipse, for a map of so many units a side.
vec2 rtwPixelOnMap(MapSample m, float side)
{
  mat2 moves = side * (rtwWarpSlope(rtwLayer, m.q) * m.moves);
  return vec2(length(vec2(moves[0].x, moves[1].x)), length(vec2(moves[0].y, moves[1].y)));
}

vec2 rtwAliasing(MapSample m)
{
  return 1.0 / max(rtwPixelOnMap(m, float(rtwWarpSize.y)), 1e-30);
}
