// The inverse of the warp at the texels' centres, a column of the map a work group: t by the column's function, which is put together once,
// then s by that of the row which t lies in.
layout(local_size_x = 32) in;
const int MOST_CELLS = 2048;

layout(std430, binding = 1) writeonly buffer Grid
{
  vec2 rtwGrid[];
};
uniform int rtwLayer;
shared float rtwColumn[MOST_CELLS + 1];

float rtwAtBorder(float line, int border)
{
  return border < rtwWarpSize.x ? rtwGridEntry(rtwLayer, 0, line, border).x : 1.0;
}

// Among how many cells the next one is looked for first, before and behind the last one.
const int NEAR_CELLS = 2;

// The cell of a function that goes from 0 to 1, in which it reaches the target.
int rtwCellInColumn(float target, int last)
{
  int low = max(last - NEAR_CELLS, 0);
  int high = min(last + NEAR_CELLS + 1, rtwWarpSize.x);
  low = rtwColumn[low] <= target ? low : 0;
  high = rtwColumn[high] > target ? high : rtwWarpSize.x;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool before = rtwColumn[middle] <= target;
    low = before ? middle : low;
    high = before ? high : middle;
  }
  return low;
}

int rtwCellInRow(float line, float target, int last)
{
  int low = max(last - NEAR_CELLS, 0);
  int high = min(last + NEAR_CELLS + 1, rtwWarpSize.x);
  low = rtwAtBorder(line, low) <= target ? low : 0;
  high = rtwAtBorder(line, high) > target ? high : rtwWarpSize.x;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool before = rtwAtBorder(line, middle) <= target;
    low = before ? middle : low;
    high = before ? high : middle;
  }
  return low;
}

float rtwPlaceInCell(int cell, vec2 ends, float target)
{
  return (float(cell) + (target - ends.x) / (ends.y - ends.x)) / float(rtwWarpSize.x);
}

void main()
{
  int cells = rtwWarpSize.x;
  int side = rtwWarpSize.y;
  int column = int(gl_WorkGroupID.x);
  int me = int(gl_LocalInvocationIndex);
  float s = (float(column) + 0.5) / float(side);
  float line = rtwLineBefore(s);
  for (int i = me; i < cells; i += 32)
  {
    rtwColumn[i] = rtwGridEntry(rtwLayer, 1, line, i).x;
  }
  if (me == 0)
  {
    rtwColumn[cells] = 1.0;
  }
  barrier();
  // One row after another, whose cells are near each other's.
  int each = (side + 31) / 32;
  ivec2 cell = ivec2(cells / 2);
  for (int row = me * each; row < min((me + 1) * each, side); ++row)
  {
    float target = (float(row) + 0.5) / float(side);
    cell.y = rtwCellInColumn(target, cell.y);
    float t = rtwPlaceInCell(cell.y, vec2(rtwColumn[cell.y], rtwColumn[cell.y + 1]), target);
    float before = rtwLineBefore(t);
    cell.x = rtwCellInRow(before, s, cell.x);
    rtwGrid[rtwCentrePlace(rtwLayer, ivec2(column, row))] =
      vec2(rtwPlaceInCell(cell.x, rtwGridEntry(rtwLayer, 0, before, cell.x), s), t);
  }
}
