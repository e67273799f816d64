// Which parts of a focus any receiver in view lies in: a bit for each cell of a grid over it, row by row.
const int GRID = 128; // cells a side
const int GRID_WORDS = GRID / 32;
layout(std430, binding = 6) buffer UsedCells
{
  uint rtwUsedCells[]; // a layer
};

int rtwUsedPlace(int layer, int row)
{
  return (layer * GRID + row) * GRID_WORDS;
}

// The bits of one word of a row that lie between two columns.
uint rtwBitsBetween(int word, int first, int last)
{
  int low = max(first - 32 * word, 0);
  int high = min(last - 32 * word, 31);
  return low > high ? 0u : (0xffffffffu >> (31 - high)) & (0xffffffffu << low);
}
