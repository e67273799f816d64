// How far a point moves on the map while it moves over the focus: the columns are along s and t.
vec2 rtwSlopesAlong(int layer, int axis, float along, float across)
{
  if (along <= 0.0 || along >= 1.0)
  {
    return vec2(1.0, 0.0);
  }
  float cells = float(rtwWarpSize.x);
  int cell = int(clamp(floor(along * cells), 0.0, cells - 1.0));
  float f = along * cells - float(cell);
  float line = rtwLineBefore(across);
  float first = min(floor(line), cells - 2.0);
  vec2 before = rtwGridEntry(layer, axis, first, cell);
  vec2 after = rtwGridEntry(layer, axis, first + 1.0, cell);
  vec2 ends = mix(before, after, line - first);
  bool between = line > 0.0 && line < cells - 1.0;
  return cells * vec2(ends.y - ends.x, between ? mix(after.x - before.x, after.y - before.y, f) : 0.0);
}

mat2 rtwWarpSlope(int layer, vec2 q)
{
  float s = rtwWarpAlong(layer, 0, q.x, q.y);
  vec2 a = rtwSlopesAlong(layer, 0, q.x, q.y);
  vec2 b = rtwSlopesAlong(layer, 1, q.y, s);
  return mat2(a.x, b.y * a.x, a.y, b.x + b.y * a.y);
}
