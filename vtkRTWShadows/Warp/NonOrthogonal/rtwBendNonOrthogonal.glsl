// How far a non-orthogonal warp strays from a plane.
//
// A pyramid over the functions of each axis holds, for squares of 1, 2, 4 … cells, a plane near the function and how far that is from it
// at most. A triangle on the light plane then covers, on the map, the image of the triangle under the plane, widened by
// that distance at most. Across the lines, a cell reaches from the middle of one line to that of the next, and there is
// one before the first line.
layout(binding = 6) uniform samplerBuffer rtwBendTable; // a layer, an axis, a level, a line, a cell: as NearPlane
uniform int rtwBendLevels;
const int MOST_LEVELS = 16;

struct NearPlane
{
  float middle; // its value there
  vec2 slope;   // along and across
  float stray;
};

int rtwLevelSide(int level)
{
  return (rtwWarpSize.x + (1 << level)) >> level;
}

// Where a level of a pyramid begins; the last is where a pyramid ends.
uniform int rtwLevelPlaces[MOST_LEVELS + 1];

int rtwLevelPlace(int layer, int axis, int level)
{
  return (2 * layer + axis) * rtwLevelPlaces[rtwBendLevels] + rtwLevelPlaces[level];
}

// The greatest difference between a plane and another one in a box around the other's middle, which lies `from` away
// from its own.
float rtwDifference(NearPlane plane, vec2 from, NearPlane other, vec2 extent)
{
  return abs(plane.middle + dot(plane.slope, from) - other.middle) + 0.5 * dot(abs(plane.slope - other.slope), extent);
}

// The plane near the functions of one axis in a box of those two coordinates, which must not be larger than from 0 to
// 1. The plane's middle is the box's. Up to four squares of the pyramid hold the box.
NearPlane rtwPlaneIn(int layer, int axis, vec2 low, vec2 high)
{
  vec2 cellsLow = low * float(rtwWarpSize.x) + vec2(0.0, 0.5);
  vec2 cellsHigh = high * float(rtwWarpSize.x) + vec2(0.0, 0.5);
  ivec2 last = rtwWarpSize.xx - ivec2(1, 0);
  ivec2 first = min(ivec2(cellsLow), last);
  ivec2 end = min(ivec2(cellsHigh), last);
  int extent = max(end.x - first.x, end.y - first.y);
  int level = min(extent <= 1 ? 0 : findMSB(extent - 1) + 1, rtwBendLevels - 1);
  int place = rtwLevelPlace(layer, axis, level);
  int side = rtwLevelSide(level);
  float square = float(1 << level);
  vec2 middle = 0.5 * (cellsLow + cellsHigh);
  NearPlane planes[4];
  vec2 from[4];
  vec2 parts[4];
  NearPlane near = NearPlane(0.0, vec2(0.0), 0.0);
  float weights = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    ivec2 at = ivec2(k % 2 == 0 ? first.x : end.x, k / 2 == 0 ? first.y : end.y) >> level;
    vec4 entry = texelFetch(rtwBendTable, place + at.y * side + at.x);
    planes[k] = NearPlane(entry.x, entry.yz / float(rtwWarpSize.x), entry.w);
    vec2 a = max(cellsLow, vec2(at) * square);
    vec2 b = min(cellsHigh, vec2(at + 1) * square);
    vec2 centre = (vec2(at) + 0.5) * square;
    from[k] = 0.5 * (a + b);
    parts[k] = max(b - a, 0.0);
    float weight = (parts[k].x + 1e-6) * (parts[k].y + 1e-6);
    near.middle += weight * (planes[k].middle + dot(planes[k].slope, middle - centre));
    near.slope += weight * planes[k].slope;
    planes[k].middle += dot(planes[k].slope, from[k] - centre);
    weights += weight;
  }
  near.middle /= weights;
  near.slope /= weights;
  for (int k = 0; k < 4; ++k)
  {
    near.stray = max(near.stray, planes[k].stray + rtwDifference(near, from[k] - middle, planes[k], parts[k]));
  }
  near.slope *= float(rtwWarpSize.x);
  return near;
}

// The plane near the warp, of both axes, in a box of the focus: map ≈ middle + slope (q - centre), within `stray`.
struct NearMap
{
  vec2 centre;
  vec2 middle;
  mat2 slope;
  vec2 stray;
};

// Rounding error of coordinates of about 1.
const float NEAR_ROUNDING = 5e-7;
// How far beside a triangle, as a share of the focus, a texel's centre still belongs to it: ROUNDING of
// rtwBentCasterFS.glsl.
const float TRIANGLE_ROUNDING = 3e-7;

// The plane near the warp in the part of the box that is in the focus: the warp puts the rest beside the map.
NearMap rtwNearMap(int layer, vec2 low, vec2 high)
{
  low = clamp(low, 0.0, 1.0);
  high = clamp(high, low, vec2(1.0));
  vec2 centre = 0.5 * (low + high);
  if (layer >= rtwWarpedLayers)
  {
    return NearMap(centre, centre, mat2(1.0), vec2(0.0));
  }
  NearPlane rows = rtwPlaneIn(layer, 0, low, high);
  float reach = 0.5 * dot(abs(rows.slope), high - low) + rows.stray;
  vec2 s = clamp(rows.middle + vec2(-reach, reach), 0.0, 1.0);
  NearPlane columns = rtwPlaneIn(layer, 1, vec2(low.y, s.x), vec2(high.y, s.y));
  // The slope follows from both axes' by the chain rule.
  mat2 slope = mat2(rows.slope.x, columns.slope.y * rows.slope.x, rows.slope.y, columns.slope.x + columns.slope.y * rows.slope.y);
  vec2 middle = vec2(rows.middle, columns.middle + columns.slope.y * (rows.middle - 0.5 * (s.x + s.y)));
  return NearMap(centre, middle, slope, vec2(rows.stray, columns.stray + abs(columns.slope.y) * rows.stray) + NEAR_ROUNDING);
}

// The bounds on the map of a box on the light plane: low, high.
vec4 rtwBoundsOnMap(int layer, vec2 low, vec2 high)
{
  NearMap near = rtwNearMap(layer, low, high);
  vec2 extent = clamp(high, 0.0, 1.0) - clamp(low, 0.0, 1.0);
  vec2 reach = 0.5 * (abs(near.slope[0]) * extent.x + abs(near.slope[1]) * extent.y) + near.stray;
  return clamp(vec4(near.middle - reach, near.middle + reach), 0.0, 1.0);
}

// The bounds on the map of a triangle in such a box: narrower than the box's, where the triangle lies askew.
#define RTW_TRIANGLES_ON_MAP
vec4 rtwTriangleOnMap(int layer, vec2 low, vec2 high, vec2 corners[3])
{
  NearMap near = rtwNearMap(layer, low, high);
  vec2 a = near.slope * (corners[0] - near.centre);
  vec2 b = near.slope * (corners[1] - near.centre);
  vec2 c = near.slope * (corners[2] - near.centre);
  vec2 stray = near.stray + TRIANGLE_ROUNDING * (abs(near.slope[0]) + abs(near.slope[1]));
  return clamp(near.middle.xyxy + vec4(min(min(a, b), c) - stray, max(max(a, b), c) + stray), 0.0, 1.0);
}

bool rtwLeavesFocus(vec2 low, vec2 high)
{
  return any(lessThan(low, vec2(0.0))) || any(greaterThan(high, vec2(1.0)));
}

// How far, along both axes of the map, a triangle in the box strays from the one through its warped corners: those stray too. All the map
// where some of them may be in the focus and others not.
vec2 rtwBends(int layer, vec2 low, vec2 high)
{
  vec2 stray = rtwNearMap(layer, low, high).stray; // wherever it is, so that rtwShifts() finds it found
  return layer < rtwWarpedLayers && rtwLeavesFocus(low, high) ? vec2(1.0) : 2.0 * stray;
}

// The bends of rtwBends() as lengths on the light plane: how far the point that a plane puts somewhere on the map is
// from the one that belongs there.
vec2 rtwShifts(int layer, vec2 low, vec2 high)
{
  NearMap near = rtwNearMap(layer, low, high);
  mat2 m = near.slope;
  vec2 stray = 2.0 * near.stray / max(abs(m[0].x * m[1].y - m[0].y * m[1].x), 1e-30);
  return vec2(abs(m[1].y) * stray.x + abs(m[1].x) * stray.y, abs(m[0].y) * stray.x + abs(m[0].x) * stray.y);
}

// The greatest bends of any box no larger than `piece` between the two corners.
vec2 rtwBendsOfPieces(int layer, vec2 low, vec2 high, vec2 piece)
{
  return rtwBends(layer, low, high);
}

// Tiles of 4, 8, 16 … texels a side. The centres of a tile's texels lie, on the light plane, in the parallelogram of `middle` and
// both half sides, or no more than `stray` from a point of it.
const int LEAST_TILE_LEVEL = 2;

struct Tile
{
  vec2 middle;
  vec2 stray;
  vec2 alongX;
  vec2 alongY;
};

int rtwTileSide(int level)
{
  return (rtwWarpSize.y + (1 << level) - 1) >> level;
}

// The levels of the pyramid of tiles, which lies behind the pyramids of all layers.
uniform int rtwTileLevels;
uniform int rtwTilePlaces[MOST_LEVELS + 1];

int rtwTilePlace(int layer, int level, ivec2 tile)
{
  int before = layer * rtwTilePlaces[rtwTileLevels] + rtwTilePlaces[level - LEAST_TILE_LEVEL] + tile.y * rtwTileSide(level) + tile.x;
  return rtwLevelPlace(rtwWarpedLayers, 0, 0) + 2 * before;
}

Tile rtwTile(int layer, int level, ivec2 tile)
{
  if (layer < rtwWarpedLayers)
  {
    int place = rtwTilePlace(layer, level, tile);
    vec4 middle = texelFetch(rtwBendTable, place);
    vec4 sides = texelFetch(rtwBendTable, place + 1);
    return Tile(middle.xy, middle.zw, sides.xy, sides.zw);
  }
  vec2 first = vec2(tile << level) + 0.5;
  vec2 end = vec2(min((tile + 1) << level, rtwWarpSize.yy)) - 0.5;
  vec2 extent = 0.5 * (end - first) / float(rtwWarpSize.y);
  return Tile(0.5 * (first + end) / float(rtwWarpSize.y), vec2(0.0), vec2(extent.x, 0.0), vec2(0.0, extent.y));
}
