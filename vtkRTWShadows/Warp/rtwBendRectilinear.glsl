// How far a warping function strays from a straight line.
//
// A function whose slope lies between a and b leaves its chord over an interval of length h by (b - a) h / 4 at most.
// The least and greatest slope of any range of cells, and the largest step between two neighbours, are two reads in a table of
// ranges of 2^k cells.
layout(binding = 6) uniform samplerBuffer rtwBendTable;
uniform int rtwBendLevels;

vec3 rtwSlopes(int layer, int axis, float low, float high)
{
  int last = rtwWarpSize.x - 1;
  int first = clamp(int(floor(low * float(rtwWarpSize.x))), 0, last);
  int end = clamp(int(floor(high * float(rtwWarpSize.x))), first, last);
  int level = findMSB(end - first + 1);
  int row = (2 * layer + axis) * rtwBendLevels + level;
  vec3 a = texelFetch(rtwBendTable, row * rtwWarpSize.x + first).xyz;
  vec3 b = texelFetch(rtwBendTable, row * rtwWarpSize.x + end + 1 - (1 << level)).xyz;
  return vec3(min(a.x, b.x), max(a.yz, b.yz));
}

// Over an interval of that length, from the slopes around it. Each cell border bends by a step at most; the borders in the interval are
// few, or as good as evenly spread.
float rtwBendOver(vec3 slopes, float h)
{
  float cells = h * float(rtwWarpSize.x);
  float steps = min(2.0 * ceil(cells) * cells, (cells + 1.0) * (cells + 1.0)) / float(8 * rtwWarpSize.x);
  return min(0.25 * (slopes.y - slopes.x) * h, slopes.z * steps);
}

float rtwBend(int layer, int axis, float low, float high)
{
  return rtwBendOver(rtwSlopes(layer, axis, low, high), high - low);
}

// The same as a length on the light plane: how far the point that a chord puts somewhere on the map is from the one that belongs there.
float rtwShift(int layer, int axis, float low, float high)
{
  vec3 slopes = rtwSlopes(layer, axis, low, high);
  return rtwBendOver(slopes, high - low) / max(slopes.x, 1e-30);
}

// The most of any interval no longer than `piece` between the two ends.
float rtwBendOfPieces(int layer, int axis, float low, float high, float piece)
{
  return rtwBendOver(rtwSlopes(layer, axis, low, high), piece);
}
