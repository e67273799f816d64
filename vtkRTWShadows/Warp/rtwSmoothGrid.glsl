// The mean of what neighbouring lines ask for (Milet et al. 2015, step 5), by running sums: three passes make nearly a Gaussian. To smooth what
// is asked for is to smooth the functions, weighted by the samples of each line.
layout(local_size_x = 32) in;

layout(std430, binding = 0) readonly buffer Collected
{
  uint rtwCollected[]; // a line, a cell: low and high part of a sum
};
layout(std430, binding = 1) buffer Smoothed
{
  float rtwSmoothed[]; // two times: a line, a cell
};
uniform ivec2 rtwWarpSize;
uniform int rtwPass;
uniform float rtwUnit;
uniform float rtwRadius; // in lines

int cells = rtwWarpSize.x;
int cell = int(gl_GlobalInvocationID.x);

float rtwLine(int line)
{
  if (line < 0 || line >= cells)
  {
    return 0.0;
  }
  int at = line * cells + cell;
  return rtwPass == 0 ? rtwUnit * (float(rtwCollected[2 * at]) + 4294967296.0 * float(rtwCollected[2 * at + 1]))
                      : rtwSmoothed[(1 - rtwPass % 2) * cells * cells + at];
}

// A window ends in parts of a line, so that its width is continuous.
void main()
{
  if (cell >= cells)
  {
    return;
  }
  int whole = int(floor(rtwRadius));
  float part = rtwRadius - float(whole);
  float sum = 0.0;
  for (int line = 0; line < whole; ++line)
  {
    sum += rtwLine(line);
  }
  for (int line = 0; line < cells; ++line)
  {
    sum += rtwLine(line + whole);
    float ends = part * (rtwLine(line + whole + 1) + rtwLine(line - whole - 1));
    rtwSmoothed[(rtwPass % 2) * cells * cells + line * cells + cell] = max(sum + ends, 0.0) / (2.0 * rtwRadius + 1.0);
    sum -= rtwLine(line - whole);
  }
}
