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

// How far a function strays over an interval of length h, from the slopes around it. Each cell border bends by a step
// at most; the borders in the interval are few, or as good as evenly spread.
float rtwBendOver(vec3 slopes, float h)
{
  float cells = h * float(rtwWarpSize.x);
  float steps = min(2.0 * ceil(cells) * cells, (cells + 1.0) * (cells + 1.0)) / float(8 * rtwWarpSize.x);
  return min(0.25 * (slopes.y - slopes.x) * h, slopes.z * steps);
}

// The bounds on the map of a box on the light plane: low, high.
vec4 rtwBoundsOnMap(int layer, vec2 low, vec2 high)
{
  return vec4(rtwWarp(layer, low), rtwWarp(layer, high));
}

// How far, along both axes of the map, a straight line in the box strays.
vec2 rtwBends(int layer, vec2 low, vec2 high)
{
  return vec2(rtwBendOver(rtwSlopes(layer, 0, low.x, high.x), high.x - low.x),
    rtwBendOver(rtwSlopes(layer, 1, low.y, high.y), high.y - low.y));
}

float rtwShift(vec3 slopes, float h)
{
  return rtwBendOver(slopes, h) / max(slopes.x, 1e-30);
}

// The bends of rtwBends() as lengths on the light plane: how far the point that a chord puts somewhere on the map is
// from the one that belongs there.
vec2 rtwShifts(int layer, vec2 low, vec2 high)
{
  return vec2(rtwShift(rtwSlopes(layer, 0, low.x, high.x), high.x - low.x),
    rtwShift(rtwSlopes(layer, 1, low.y, high.y), high.y - low.y));
}

// The greatest bends of any box no larger than `piece` between the two corners.
vec2 rtwBendsOfPieces(int layer, vec2 low, vec2 high, vec2 piece)
{
  return vec2(rtwBendOver(rtwSlopes(layer, 0, low.x, high.x), piece.x),
    rtwBendOver(rtwSlopes(layer, 1, low.y, high.y), piece.y));
}
