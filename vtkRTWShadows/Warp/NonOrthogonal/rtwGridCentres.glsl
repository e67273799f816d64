// The inverse of the warp at the texels' centres, a column of the map a work group: t by the column's function, then s by that of the row
// which t lies in.
layout(local_size_x = 32) in;
layout(std430, binding = 1) writeonly buffer Grid
{
  vec2 rtwGrid[];
};
uniform int rtwLayer;

// A search for a cell: from a guess in steps that double until it lies between two cells, then in halves.
struct CellSearch
{
  int cell;
  int low;  // the first that it may be, and the one behind the last
  int high;
  int step;
};

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

// Where a function reaches the target, near a guess.
float rtwReached(int axis, float line, float target, float guess)
{
  float cells = float(rtwWarpSize.x);
  CellSearch search = CellSearch(int(clamp(guess * cells, 0.0, cells - 1.0)), 0, rtwWarpSize.x, 1);
  vec2 ends = vec2(0.0, 1.0);
  bool isToDo = true;
  while (isToDo)
  {
    ends = rtwGridEntry(rtwLayer, axis, line, search.cell);
    isToDo = rtwSearchOn(search, ends, target);
  }
  return (float(search.cell) + (target - ends.x) / (ends.y - ends.x)) / cells;
}

void main()
{
  int side = rtwWarpSize.y;
  int column = int(gl_WorkGroupID.x);
  float s = (float(column) + 0.5) / float(side);
  float line = rtwLineBefore(s);
  // One row after another: the next centre is about as far from this one as that was from the one before.
  int each = (side + 31) / 32;
  int first = int(gl_LocalInvocationIndex) * each;
  vec2 q = vec2(s, (float(first) + 0.5) / float(side));
  vec2 step = vec2(0.0);
  for (int row = first; row < min(first + each, side); ++row)
  {
    vec2 guess = q + step;
    q.y = rtwReached(1, line, (float(row) + 0.5) / float(side), guess.y);
    q.x = rtwReached(0, rtwLineBefore(q.y), s, guess.x);
    step = row == first ? vec2(0.0) : q - guess + step;
    rtwGrid[rtwCentrePlace(rtwLayer, ivec2(column, row))] = q;
  }
}
