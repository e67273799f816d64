// The functions of one axis, one a work group, from what each line's cells ask for.
layout(local_size_x = GROUP) in;

layout(std430, binding = 0) readonly buffer Smoothed
{
  float rtwSmoothed[];
};
layout(std430, binding = 1) writeonly buffer Grid
{
  vec2 rtwGrid[];
};
layout(std430, binding = 2) buffer Report
{
  uint rtwGreatest[]; // a layer, an axis: slope of all functions, as bits
};
uniform int rtwLayer;
uniform int rtwAxis;
uniform int rtwIsUnderRoot;

void main()
{
  int cells = rtwWarpSize.x;
  int line = int(gl_WorkGroupID.x);
  for (int i = me; i < cells; i += GROUP)
  {
    float asked = rtwSmoothed[line * cells + i];
    rtwSums[i] = rtwIsUnderRoot != 0 ? sqrt(asked) : asked;
  }
  barrier();
  blur(cells);
  raise(cells);
  sumUp(cells);
  float steepest = 0.0;
  for (int i = me; i < cells; i += GROUP)
  {
    steepest = max(steepest, rtwSums[i + 1] - rtwSums[i]);
    rtwGrid[rtwGridPlace(rtwLayer, rtwAxis, line, i)] = vec2(rtwSums[i], rtwSums[i + 1]);
  }
  atomicMax(rtwGreatest[2 * rtwLayer + rtwAxis], floatBitsToUint(steepest * float(cells)));
}
