// What is remembered of the last frame, an axis of a layer: its focus as in the warp table, what light-plane coordinates have been
// shifted by since then, whether anything is known, and the values of two warping functions at the borders of their cells: the
// one that was in use, and the one that was wanted.
layout(std430, binding = 5) buffer Functions
{
  float rtwFunctions[];
};
const int MEASURES = 4; // before the functions, as in rtwWarpHistory.cxx
const int USED = 0;
const int WANTED = 1;

int rtwHistoryPlace(int layer, int axis)
{
  return (MEASURES + 2 * (rtwWarpSize.x + 1)) * (2 * layer + axis);
}

bool rtwIsKnown(int layer)
{
  return rtwFunctions[rtwHistoryPlace(layer, 0) + 3] != 0.0;
}

// The low end of the last frame's focus in this frame's light-plane coordinates, and one over its extent.
vec2 rtwLastFocus(int layer, int axis)
{
  int place = rtwHistoryPlace(layer, axis);
  return vec2(rtwFunctions[place] + rtwFunctions[place + 2], rtwFunctions[place + 1]);
}

int rtwFunctionPlace(int layer, int axis, int function)
{
  return rtwHistoryPlace(layer, axis) + MEASURES + function * (rtwWarpSize.x + 1);
}
