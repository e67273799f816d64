// Cells of a warping function that no receiver in view needs get next to nothing of the map: those that are out of reach of the blur, in
// cells, and of the filter, on the map.
uniform float rtwReach; // of the filter, a share of the map's side
shared uint rtwUsedBits[GRID_WORDS];

// Finds the columns in use where the function is along s, and the rows where it is along t.
void findUsed()
{
  if (me < GRID_WORDS)
  {
    rtwUsedBits[me] = 0u;
  }
  barrier();
  if (me < GRID)
  {
    uint any = 0u;
    for (int word = 0; word < GRID_WORDS; ++word)
    {
      uint bits = rtwUsedCells[rtwUsedPlace(layer, me) + word];
      any |= bits;
      if (axis == 0)
      {
        atomicOr(rtwUsedBits[word], bits);
      }
    }
    if (axis == 1 && any != 0u)
    {
      atomicOr(rtwUsedBits[me / 32], 1u << (me % 32));
    }
  }
  barrier();
}

// The last one in use that is not behind a line of the grid, or -1.
int usedUpTo(int line)
{
  for (int word = line / 32; word >= 0; --word)
  {
    uint bits = rtwUsedBits[word] & rtwBitsBetween(word, 0, line);
    if (bits != 0u)
    {
      return 32 * word + findMSB(bits);
    }
  }
  return -1;
}

// The first one in use that is not before a line of the grid, or GRID.
int usedFrom(int line)
{
  for (int word = line / 32; word < GRID_WORDS; ++word)
  {
    uint bits = rtwUsedBits[word] & rtwBitsBetween(word, line, GRID - 1);
    if (bits != 0u)
    {
      return 32 * word + findLSB(bits);
    }
  }
  return GRID;
}

bool isNeeded(int cell, int cells)
{
  int radius = int(ceil(3.0 * rtwSigma));
  int below = usedUpTo(((cell + 1) * GRID - 1) / cells);
  int above = usedFrom(cell * GRID / cells);
  int end = ((below + 1) * cells + GRID - 1) / GRID; // of the cells in use below
  int start = above * cells / GRID;
  bool nearBelow = below >= 0 && (cell - end < radius || rtwSums[cell] - rtwSums[min(end, cell)] < rtwReach);
  bool nearAbove = above < GRID && (start - cell - 1 < radius || rtwSums[max(start, cell + 1)] - rtwSums[cell + 1] < rtwReach);
  return nearBelow || nearAbove;
}

void cull(int cells)
{
  findUsed();
  bool any = usedFrom(0) < GRID;
  for (int i = me; i < cells; i += GROUP)
  {
    rtwValues[i] = any && !isNeeded(i, cells) ? 0.0 : max(rtwSums[i + 1] - rtwSums[i], rtwLeast);
  }
  barrier();
  float least = rtwLeast * total(cells);
  for (int i = me; i < cells; i += GROUP)
  {
    rtwValues[i] = max(rtwValues[i], least);
  }
  barrier();
  sumUp(cells);
}
