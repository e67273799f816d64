// How far a point moves on the map while it moves over the focus: the columns are along s and t.
mat2 rtwWarpSlope(int layer, vec2 q)
{
  vec4 p = rtwPerspective(layer);
  float h = 1.0 + p.z * q.y;
  float s = 1.0 / (h * (p.y - p.x));
  return mat2(s, 0.0, -s * p.z * (q.x - p.w) / h, (1.0 + p.z) / (h * h));
}
