// How far a point moves on the map while it moves over the focus: the columns are along s and t.
float rtwSlopeAlong(int row, float x)
{
  int cell = clamp(int(floor(x * float(rtwWarpSize.x))), 0, rtwWarpSize.x - 1);
  vec2 ends = rtwWarpEntry(row, cell);
  return (ends.y - ends.x) * float(rtwWarpSize.x);
}

mat2 rtwWarpSlope(int layer, vec2 q)
{
  return mat2(rtwSlopeAlong(4 * layer, q.x), 0.0, 0.0, rtwSlopeAlong(4 * layer + 1, q.y));
}
