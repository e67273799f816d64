// The inverse of the warp at the texels' centres, a column of the map a work group: t by the column's function, which is put together once,
// then s by that of the row which t lies in.
layout(local_size_x = 32) in;
const int MOST_CELLS = 2048;

layout(std430, binding = 1) buffer Grid
{
  vec2 rtwGrid[];
};
uniform int rtwLayer;
shared float rtwColumn[MOST_CELLS + 1];

// As rtwGridEntry has it, along s.
vec2 rtwStoredEntry(float line, int cell)
{
  float first = min(floor(line), float(rtwWarpSize.x - 2));
  int place = rtwGridPlace(rtwLayer, 0, int(first), cell);
  return mix(rtwGrid[place], rtwGrid[place + rtwWarpSize.x], line - first);
}

// A search for a cell: from a guess in steps that double until it lies between two cells, then in halves.
struct CellSearch
{
  int cell;
  int low;  // the first that it may be, and the one behind the last
  int high;
  int step;
};

CellSearch rtwSearchFrom(int guess)
{
  return CellSearch(guess, 0, rtwWarpSize.x, 1);
}

// False where the cell with those ends is found.
bool rtwSearchOn(inout CellSearch search, vec2 ends, float target)
{
  bool before = target < ends.x;
  bool behind = target >= ends.y;
  search.high = before ? search.cell : search.high;
  search.low = behind ? search.cell + 1 : search.low;
  bool between = search.low > 0 && search.high < rtwWarpSize.x;
  int next = between ? (search.low + search.high) / 2 : search.cell + (before ? -search.step : search.step);
  search.step *= 2;
  search.cell = before || behind ? clamp(next, search.low, max(search.high - 1, search.low)) : search.cell;
  return (before || behind) && search.low < search.high;
}

// The cell of the column's function, in which it reaches the target.
int rtwCellInColumn(float target, int guess)
{
  CellSearch search = rtwSearchFrom(guess);
  bool isToDo = true;
  while (isToDo)
  {
    isToDo = rtwSearchOn(search, vec2(rtwColumn[search.cell], rtwColumn[search.cell + 1]), target);
  }
  return search.cell;
}

// Of a row's, and its ends.
int rtwCellInRow(float line, float target, int guess, out vec2 ends)
{
  CellSearch search = rtwSearchFrom(guess);
  bool isToDo = true;
  while (isToDo)
  {
    ends = rtwStoredEntry(line, search.cell);
    isToDo = rtwSearchOn(search, ends, target);
  }
  return search.cell;
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
    vec2 ends;
    cell.x = rtwCellInRow(before, s, cell.x, ends);
    rtwGrid[rtwCentrePlace(rtwLayer, ivec2(column, row))] =
      vec2(rtwPlaceInCell(cell.x, ends, s), t);
  }
}
