// What is asked for, in a coarse grid, by which smoothing is chosen.
layout(local_size_x = COARSE_CELLS) in;

layout(std430, binding = 0) readonly buffer Collected
{
  uint rtwCollected[]; // a line, a cell: low and high part of a sum
};
layout(std430, binding = 1) writeonly buffer Coarse
{
  float rtwCoarse[]; // a line, a cell
};
uniform ivec2 rtwWarpSize;
uniform int rtwFirst; // where the sums of the axis begin, in cells
uniform int rtwLineLength;
uniform float rtwUnit;

void main()
{
  int cells = rtwWarpSize.x;
  ivec2 at = ivec2(gl_LocalInvocationID.x, gl_WorkGroupID.x);
  ivec2 first = at * cells / COARSE_CELLS;
  ivec2 end = (at + 1) * cells / COARSE_CELLS;
  float sum = 0.0;
  for (int line = first.y; line < end.y; ++line)
  {
    for (int cell = first.x; cell < end.x; ++cell)
    {
      int i = 2 * (rtwFirst + line * rtwLineLength + cell);
      sum += rtwUnit * (float(rtwCollected[i]) + 4294967296.0 * float(rtwCollected[i + 1]));
    }
  }
  rtwCoarse[at.y * COARSE_CELLS + at.x] = sum;
}
