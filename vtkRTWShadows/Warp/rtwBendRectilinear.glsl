// How far a warping function strays from a straight line.
//
// A function whose slope lies between a and b leaves its chord over an interval of length h by (b - a) h / 4 at most.
// The least and greatest slope of any range of cells, and the largest step between two neighbours, are two reads in a table of
// ranges of 2^k cells.
layout(binding = 6) uniform sampler2D rtwBendTable;
uniform int rtwBendLevels;

vec3 rtwSlopes(int layer, int axis, float low, float high)
{
  int last = rtwWarpSize.x - 1;
  int first = clamp(int(floor(low * float(rtwWarpSize.x))), 0, last);
  int end = clamp(int(floor(high * float(rtwWarpSize.x))), first, last);
  int level = findMSB(end - first + 1);
  int row = (2 * layer + axis) * rtwBendLevels + level;
  vec3 a = texelFetch(rtwBendTable, ivec2(first, row), 0).xyz;
  vec3 b = texelFetch(rtwBendTable, ivec2(end + 1 - (1 << level), row), 0).xyz;
  return vec3(min(a.x, b.x), max(a.yz, b.yz));
}

float rtwBend(int layer, int axis, float low, float high)
{
  vec3 slopes = rtwSlopes(layer, axis, low, high);
  return 0.25 * (slopes.y - slopes.x) * (high - low);
}

// The most of any interval no longer than `piece` between the two ends.
float rtwBendOfPieces(int layer, int axis, float low, float high, float piece)
{
  vec3 slopes = rtwSlopes(layer, axis, low, high);
  float steps = ceil(piece * float(rtwWarpSize.x)) * slopes.z;
  return 0.25 * min(slopes.y - slopes.x, steps) * piece;
}
