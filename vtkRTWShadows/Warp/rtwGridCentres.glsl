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

float rtwInColumn(float target)
{
  int low = 0;
  int high = rtwWarpSize.x;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    low = rtwColumn[middle] <= target ? middle : low;
    high = rtwColumn[middle] <= target ? high : middle;
  }
  return (float(low) + (target - rtwColumn[low]) / (rtwColumn[low + 1] - rtwColumn[low])) / float(rtwWarpSize.x);
}

float rtwInRow(float t, float target)
{
  float line = rtwLineBefore(t);
  int low = 0;
  int high = rtwWarpSize.x;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool before = rtwAtBorder(line, middle) <= target;
    low = before ? middle : low;
    high = before ? high : middle;
  }
  vec2 ends = rtwGridEntry(rtwLayer, 0, line, low);
  return (float(low) + (target - ends.x) / (ends.y - ends.x)) / float(rtwWarpSize.x);
}

void main()
{
  int cells = rtwWarpSize.x;
  int side = rtwWarpSize.y;
  int column = int(gl_WorkGroupID.x);
  float s = (float(column) + 0.5) / float(side);
  float line = rtwLineBefore(s);
  for (int i = int(gl_LocalInvocationIndex); i < cells; i += 32)
  {
    rtwColumn[i] = rtwGridEntry(rtwLayer, 1, line, i).x;
  }
  if (gl_LocalInvocationIndex == 0u)
  {
    rtwColumn[cells] = 1.0;
  }
  barrier();
  for (int row = int(gl_LocalInvocationIndex); row < side; row += 32)
  {
    float t = rtwInColumn((float(row) + 0.5) / float(side));
    rtwGrid[rtwCentrePlace(rtwLayer, ivec2(column, row))] = vec2(rtwInRow(t, s), t);
  }
}
