// The aliasing error m = w'_l / w'_i: how wide a texel is on a surface, beside a pixel (Lloyd et al. 2006, equation 1, the exact form).
// A pixel is as wide along s and t as the ellipse that its round beam becomes on the map, where a texel is 1 wide.

// The steps on a layer's map, which is `size` units long along s and t, from a pixel to the one on the right and to the
// one above.
mat2 rtwMovesOnMap(int layer, MapSample m, vec2 size)
{
  mat2 moves = rtwWarpSlope(layer, m.q) * m.moves;
  return mat2(size * moves[0], size * moves[1]);
}

// The extent along s and t of the ellipse that the round beam of a pixel becomes on the map.
vec2 rtwPixelOnMap(MapSample m, vec2 size)
{
  mat2 moves = rtwMovesOnMap(m.layer, m, size);
  return vec2(length(vec2(moves[0].x, moves[1].x)), length(vec2(moves[0].y, moves[1].y)));
}

vec2 rtwAliasing(MapSample m)
{
  return 1.0 / max(rtwPixelOnMap(m, vec2(rtwMapSize)), 1e-30);
}
