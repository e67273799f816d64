// How far a point moves on the map while it moves over the focus: the columns are along s and t.
mat2 rtwWarpSlope(int layer, vec2 q)
{
  return mat2(1.0);
}
