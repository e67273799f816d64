// A warping map from a collapsed importance, by its running sum, its inverse at the texels' centres, and the table of slopes.
// One work group an axis and a layer.
layout(local_size_x = GROUP) in;

layout(std430, binding = 0) buffer Profile
{
  uint rtwProfile[]; // as rtwImportance.glsl fills it
};
layout(std430, binding = 1) buffer Report
{
  float rtwReport[]; // a layer, an axis: the greatest slope, and the focus' extent
};
layout(std430, binding = 2) writeonly buffer Table
{
  vec2 rtwTable[];
};
layout(std430, binding = 3) buffer Bends
{
  vec4 rtwBends[]; // least slope, greatest slope, greatest step
};
layout(std430, binding = 4) writeonly buffer Profiles
{
  float rtwImportance[]; // a layer, an axis, a cell: as collected, and as used
};
const int LARGEST = 0; // values of rtwCollected: what the profile holds, as enum Collected of rtwImportanceStage.h
const int SUM = 1;
const int SUM_UNDER_ROOT = 2;
const float EDGE_FLOOR = 0.02; // share of the plain demand that is added to the demand at shadow edges
uniform int rtwCollected;
uniform float rtwUnit; // the value of an integer sum of 1
uniform int rtwProfiles; // 1, or 2 where there is one at shadow edges behind the plain one
uniform int rtwLevels;
uniform int rtwCulling;   // whether cells that are not in use are left out
uniform int rtwRemembers; // whether the last frame counts

int layer = int(gl_WorkGroupID.y);
int axis = int(gl_WorkGroupID.x);

float sumOf(int profile, int cell, int cells)
{
  int at = 2 * (((2 * layer + axis) * rtwProfiles + profile) * cells + cell);
  return float(rtwProfile[at]) + 4294967296.0 * float(rtwProfile[at + 1]);
}

float totalOf(int profile, int cells)
{
  for (int i = me; i < cells; i += GROUP)
  {
    rtwValues[i] = sumOf(profile, i, cells);
  }
  barrier();
  return total(cells);
}

// Demand at shadow edges alone, with a share of the plain one so that nothing starves; the plain one where there are no edges.
vec2 weights(int cells)
{
  float edges = rtwProfiles == 2 ? totalOf(1, cells) : 0.0;
  float plain = rtwProfiles == 2 ? totalOf(0, cells) : 0.0;
  return edges > 0.0 ? vec2(EDGE_FLOOR * edges / plain, 1.0) : vec2(1.0, 0.0);
}

void load(int cells)
{
  vec2 weight = weights(cells);
  for (int i = me; i < cells; i += GROUP)
  {
    float sum = weight.x * sumOf(0, i, cells) + (weight.y > 0.0 ? weight.y * sumOf(1, i, cells) : 0.0);
    float largest = uintBitsToFloat(rtwProfile[2 * (2 * layer + axis) * rtwProfiles * cells + 2 * i]);
    sum *= rtwUnit;
    rtwSums[i] = rtwCollected == LARGEST ? largest : rtwCollected == SUM ? sum : sqrt(sum);
    rtwImportance[2 * ((2 * layer + axis) * cells + i)] = rtwSums[i];
  }
  barrier();
}

void writeInverse(int cells, int row)
{
  int resolution = rtwWarpSize.y;
  for (int texel = me; texel < resolution; texel += GROUP)
  {
    vec2 centres;
    for (int k = 0; k < 2; ++k)
    {
      float target = (float(texel + k) + 0.5) / float(resolution);
      int low = 0;
      int high = cells;
      while (high - low > 1)
      {
        int middle = (low + high) / 2;
        if (rtwSums[middle] <= target)
        {
          low = middle;
        }
        else
        {
          high = middle;
        }
      }
      centres[k] = (float(low) + (target - rtwSums[low]) / (rtwSums[low + 1] - rtwSums[low])) / float(cells);
    }
    rtwTable[rtwWarpPlace(row, texel)] = centres;
  }
}

void writeSlopes(int cells)
{
  int row = (2 * layer + axis) * rtwLevels;
  for (int i = me; i < cells; i += GROUP)
  {
    float slope = (rtwSums[i + 1] - rtwSums[i]) * float(cells);
    int next = min(i + 1, cells - 1);
    float nextSlope = (rtwSums[next + 1] - rtwSums[next]) * float(cells);
    rtwBends[row * cells + i] = vec4(slope, slope, abs(nextSlope - slope), 0.0);
  }
  for (int level = 1; level < rtwLevels; ++level)
  {
    memoryBarrierBuffer();
    barrier();
    int span = 1 << (level - 1);
    for (int i = me; i + 2 * span <= cells; i += GROUP)
    {
      vec3 a = rtwBends[(row + level - 1) * cells + i].xyz;
      vec3 b = rtwBends[(row + level - 1) * cells + i + span].xyz;
      rtwBends[(row + level) * cells + i] = vec4(min(a.x, b.x), max(a.yz, b.yz), 0.0);
    }
  }
}

// Defined in rtwFollowWarp.glsl and rtwCullCells.glsl, which follow.
void blendWithLast(int cells);
void cull(int cells);
void snapToLast(int cells);

void main()
{
  int cells = rtwWarpSize.x;
  load(cells);
  blur(cells);
  raise(cells);
  sumUp(cells);
  if (rtwRemembers != 0)
  {
    blendWithLast(cells);
  }
  if (rtwCulling != 0)
  {
    cull(cells);
  }
  if (rtwRemembers != 0)
  {
    snapToLast(cells);
  }
  for (int i = me; i < cells; i += GROUP)
  {
    rtwTable[rtwWarpPlace(4 * layer + axis, i)] = vec2(rtwSums[i], rtwSums[i + 1]);
    rtwImportance[2 * ((2 * layer + axis) * cells + i) + 1] = rtwValues[i];
  }
  writeInverse(cells, 4 * layer + 2 + axis);
  writeSlopes(cells);
  if (me == 0)
  {
    float steepest = 0.0;
    for (int i = 0; i < cells; ++i)
    {
      steepest = max(steepest, (rtwSums[i + 1] - rtwSums[i]) * float(cells));
    }
    vec4 focus = rtwFocus(layer);
    rtwReport[2 * (2 * layer + axis)] = steepest;
    rtwReport[2 * (2 * layer + axis) + 1] = 1.0 / (axis == 0 ? focus.y : focus.w);
  }
}
