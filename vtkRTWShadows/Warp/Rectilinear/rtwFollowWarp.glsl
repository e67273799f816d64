// How a warping function follows the last frame's.
uniform int rtwSnapping;
uniform float rtwBlending;   // the share of the last frame's function
uniform float rtwMostExcess; // share of error above the least that a function may have and stay

void remember(int cells, int function)
{
  int place = rtwFunctionPlace(layer, axis, function);
  barrier();
  for (int i = me; i <= cells; i += GROUP)
  {
    rtwFunctions[place + i] = rtwSums[i];
  }
}

// The function that was wanted, at a place in its focus. It goes on beyond its ends.
float rtwLastWanted(int place, int cells, float x)
{
  float f = x * float(cells);
  int cell = clamp(int(floor(f)), 0, cells - 1);
  float low = rtwFunctions[place + cell];
  return low + (f - float(cell)) * (rtwFunctions[place + cell + 1] - low);
}

// Blends with the last frame's function: a convex combination of strictly monotone functions is strictly monotone.
void blendWithLast(int cells)
{
  if (rtwIsKnown(layer) && rtwBlending > 0.0)
  {
    vec2 focus = rtwWarpEntry(4 * layer + axis, cells);
    vec2 last = rtwLastFocus(layer, axis);
    int place = rtwFunctionPlace(layer, axis, WANTED);
    float start = (focus.x - last.x) * last.y;
    float cell = last.y / focus.y / float(cells);
    float all = rtwLastWanted(place, cells, start + cell * float(cells)) - rtwLastWanted(place, cells, start);
    for (int i = me; i < cells; i += GROUP)
    {
      float was = rtwLastWanted(place, cells, start + cell * float(i + 1)) - rtwLastWanted(place, cells, start + cell * float(i));
      rtwValues[i] = max(mix(rtwSums[i + 1] - rtwSums[i], was / all, rtwBlending), rtwLeast);
    }
    barrier();
    sumUp(cells);
  }
  remember(cells, WANTED);
}

// The error of the last function that was in use, if this one were best: a shadow's edge in a cell that wants p texels
// and gets k is off by p · p / k (the error is the sum of demand over density, and the density of p is the root of
// demand).
float rtwLastError(int cells)
{
  int place = rtwFunctionPlace(layer, axis, USED);
  float error = 0.0;
  for (int i = me; i < cells; i += GROUP)
  {
    float p = rtwSums[i + 1] - rtwSums[i];
    float k = rtwFunctions[place + i + 1] - rtwFunctions[place + i];
    // A cell that the last function culled and this one wants makes the error infinite.
    error += k < 2.0 * rtwLeast && p >= 2.0 * rtwLeast ? 1e30 : p * p / k;
  }
  return totalOf(error);
}

void snapToLast(int cells)
{
  vec2 focus = rtwWarpEntry(4 * layer + axis, cells);
  if (rtwIsKnown(layer) && rtwSnapping != 0)
  {
    vec2 last = rtwLastFocus(layer, axis);
    bool isSame = focus.y == last.y && abs(focus.x - last.x) * focus.y <= 1e-5;
    float error = rtwLastError(cells);
    if (isSame && error <= 1.0 + rtwMostExcess)
    {
      int place = rtwFunctionPlace(layer, axis, USED);
      for (int i = me; i <= cells; i += GROUP)
      {
        rtwSums[i] = rtwFunctions[place + i];
        rtwValues[i] = i < cells ? rtwFunctions[place + i + 1] - rtwFunctions[place + i] : 0.0;
      }
    }
    barrier();
  }
  remember(cells, USED);
  if (me == 0)
  {
    int place = rtwHistoryPlace(layer, axis);
    rtwFunctions[place] = focus.x;
    rtwFunctions[place + 1] = focus.y;
  }
}
