// Where it is written how deep the view samples lie that look up each part of a map: for squares of rising size, the deepest.
uniform int rtwSquare; // log2 of the least square's side, in texels

// The number of least squares along a side of the map, rounded up to a power of two.
int rtwDeepestSide(int texels)
{
  int squares = (texels + (1 << rtwSquare) - 1) >> rtwSquare;
  return squares <= 1 ? 1 : 2 << findMSB(squares - 1);
}

// The place of a square in the buffer, which holds level after level.
int rtwDeepestPlace(int texels, int level, ivec2 square)
{
  int base = rtwDeepestSide(texels);
  int side = base >> level;
  return (4 * (base * base - side * side)) / 3 + square.y * side + square.x;
}
