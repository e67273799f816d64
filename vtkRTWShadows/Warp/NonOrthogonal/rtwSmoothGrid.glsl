// The mean of what neighbouring lines ask for (Milet et al. 2015, step 5), by running sums: three passes make nearly a Gaussian. To smooth what
// is asked for is to smooth the functions, weighted by the samples of each line. An invocation has four cells of each line.
layout(local_size_x = 16) in;

layout(std430, binding = 1) writeonly buffer Smoothed
{
  vec4 rtwWritten[]; // two times: a line, four cells
};
layout(std430, binding = 2) readonly buffer Radius
{
  float rtwRadii[]; // the first, in lines
};
#if defined(FIRST_PASS)
uniform usamplerBuffer rtwCollected; // a line, two cells: low and high part of a sum each
#else
uniform samplerBuffer rtwSmoothed;
#endif
uniform ivec2 rtwWarpSize;
uniform int rtwPass;
uniform int rtwFirst; // where the sums of the axis begin, in cells
uniform float rtwUnit;

int cells = rtwWarpSize.x;
int quads = (cells + 3) / 4;
int quad = int(gl_GlobalInvocationID.x);

vec4 rtwLine(int line)
{
  int at = clamp(line, 0, cells - 1) * quads + quad;
#if defined(FIRST_PASS)
  uvec4 a = texelFetch(rtwCollected, rtwFirst / 2 + 2 * at);
  uvec4 b = texelFetch(rtwCollected, rtwFirst / 2 + 2 * at + 1);
  vec4 asked = rtwUnit * (vec4(a.xz, b.xz) + 4294967296.0 * vec4(a.yw, b.yw));
#else
  vec4 asked = texelFetch(rtwSmoothed, (1 - rtwPass % 2) * cells * quads + at);
#endif
  return line < 0 || line >= cells ? vec4(0.0) : asked;
}

// A window ends in parts of a line, so that its width is continuous. Each line is read twice: when it comes and when it goes.
void main()
{
  if (quad >= quads)
  {
    return;
  }
  float radius = rtwRadii[0];
  int whole = int(floor(radius));
  float part = radius - float(whole);
  vec4 sum = vec4(0.0);
  for (int line = 0; line < whole; ++line)
  {
    sum += rtwLine(line);
  }
  vec4 next = rtwLine(whole);
  vec4 gone = vec4(0.0);
  for (int line = 0; line < cells; ++line)
  {
    sum += next;
    next = rtwLine(line + whole + 1);
    rtwWritten[(rtwPass % 2) * cells * quads + line * quads + quad] = max(sum + part * (next + gone), 0.0) / (2.0 * radius + 1.0);
    gone = rtwLine(line - whole);
    sum -= gone;
  }
}
