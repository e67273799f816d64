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
layout(std430, binding = 2) readonly buffer Radius
{
  float rtwRadii[]; // the first, in lines
};
uniform ivec2 rtwWarpSize;
uniform int rtwPass;
uniform float rtwUnit;

int cells = rtwWarpSize.x;
int cell = int(gl_GlobalInvocationID.x);

float rtwLine(int line)
{
  if (line < 0 || line >= cells)
  {
    return 0.0;
  }
  int at = line * cells + cell;
#if defined(FIRST_PASS)
  return rtwUnit * (float(rtwCollected[2 * at]) + 4294967296.0 * float(rtwCollected[2 * at + 1]));
#else
  return rtwSmoothed[(1 - rtwPass % 2) * cells * cells + at];
#endif
}

// A window ends in parts of a line, so that its width is continuous. Each line is read twice: when it comes and when it goes.
void main()
{
  if (cell >= cells)
  {
    return;
  }
  float radius = rtwRadii[0];
  int whole = int(floor(radius));
  float part = radius - float(whole);
  float sum = 0.0;
  for (int line = 0; line < whole; ++line)
  {
    sum += rtwLine(line);
  }
  float next = rtwLine(whole);
  float gone = 0.0;
  for (int line = 0; line < cells; ++line)
  {
    sum += next;
    next = rtwLine(line + whole + 1);
    rtwSmoothed[(rtwPass % 2) * cells * cells + line * cells + cell] = max(sum + part * (next + gone), 0.0) / (2.0 * radius + 1.0);
    gone = rtwLine(line - whole);
    sum -= gone;
  }
}
