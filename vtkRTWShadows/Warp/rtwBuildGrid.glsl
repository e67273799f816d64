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
layout(std430, binding = 3) readonly buffer Collected
{
  uint rtwCollected[]; // a line, a cell: low and high part of a sum
};
layout(std430, binding = 4) writeonly buffer Profiles
{
  vec2 rtwProfiles[]; // a layer, an axis, a line, a cell: importance as it was collected, and as it was used
};
uniform float rtwUnit; // of what was collected
uniform int rtwLayer;
uniform int rtwAxis;
uniform int rtwIsUnderRoot;

float rtwImportanceOf(float asked)
{
  return rtwIsUnderRoot != 0 ? sqrt(asked) : asked;
}

void main()
{
  int cells = rtwWarpSize.x;
  int line = int(gl_WorkGroupID.x);
  for (int i = me; i < cells; i += GROUP)
  {
    rtwSums[i] = rtwImportanceOf(rtwSmoothed[line * cells + i]);
  }
  barrier();
  blur(cells);
  raise(cells);
  sumUp(cells);
  float steepest = 0.0;
  for (int i = me; i < cells; i += GROUP)
  {
    steepest = max(steepest, rtwSums[i + 1] - rtwSums[i]);
    int at = line * cells + i;
    float collected = rtwUnit * (float(rtwCollected[2 * at]) + 4294967296.0 * float(rtwCollected[2 * at + 1]));
    rtwProfiles[(2 * rtwLayer + rtwAxis) * cells * cells + at] = vec2(rtwImportanceOf(collected), rtwValues[i]);
    rtwGrid[rtwGridPlace(rtwLayer, rtwAxis, line, i)] = vec2(rtwSums[i], rtwSums[i + 1]);
  }
  atomicMax(rtwGreatest[2 * rtwLayer + rtwAxis], floatBitsToUint(steepest * float(cells)));
}
