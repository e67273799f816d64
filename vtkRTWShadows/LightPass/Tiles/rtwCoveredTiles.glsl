// Tiles of the map that a bent triangle's covers are made of, where the warp takes an axis to none: found from the light plane. A pyramid
// knows where the centres of each tile's texels lie there; tiles are divided until one is in the triangle, beside it, or of 4 x 4 texels,
// whose centres are looked at.
//
// All triangles' tiles of a size that are to be divided are worked on side by side, one by an invocation, from a list; those of the next
// size are put in another. A third list has what is taken: the squares of 4 x 4 texels, and whole tiles. Covers that
// aren't large are points: these lie at the end of the buffer of covers, in reverse order.
layout(std430, binding = 6) writeonly buffer Covers
{
  CasterCover rtwCovers[];
};
uniform int rtwLayer;
uniform int rtwLargestPoint; // the largest cover that is a point, in texels a side
layout(std430, binding = 4) buffer Tiles
{
  uint rtwTileCounts[3]; // number of tiles in each list
  uint rtwTileGroups[3]; // work groups for the list whose turn it is
  // How many tiles of that list may be divided at most, so that there is room for all that they become.
  uint rtwTilesToDivide;
  uint rtwUnused;
  uint rtwPointDraw[4];  // vertices, instances, first vertex, first instance
  uvec2 rtwTilesToDo[];  // each list: caster; level, row, column; of level 0 are squares of texels that begin there
};
const uint TAKEN_LIST = 2u;
const uint MOST_TILES = MOST_COVERS * MOST_CLUSTERS;
const float ROUNDING = 1e-6; // a share of the focus, not less than in rtwBentCasterFS.glsl

struct Covered
{
  uint caster;
  vec3 edges[3];
  vec2 anchor;
  vec2 corners[3]; // where it crosses the plane of a spot, of its bounds
  vec2 low;
  vec2 high;
  bool crosses;
  ivec4 texels; // the texels whose centres it can hide: first, last
  float depth;  // the least depth
  vec3 plane;   // slope of depth, and the depth of the anchor
};

Covered rtwLoadCovered(uint caster)
{
  vec4 e0 = rtwBentEntry(caster, 0);
  vec4 e1 = rtwBentEntry(caster, 1);
  vec4 e2 = rtwBentEntry(caster, 2);
  vec4 anchor = rtwBentEntry(caster, 3);
  vec4 ab = rtwBentEntry(caster, 4);
  vec4 c2 = rtwBentEntry(caster, 5);
  Covered c;
  c.caster = caster;
  c.edges = vec3[3](e0.xyz, e1.xyz, e2.xyz);
  c.anchor = anchor.xy;
  c.corners = vec2[3](ab.xy, ab.zw, c2.xy);
  c.low = min(min(ab.xy, ab.zw), c2.xy);
  c.high = max(max(ab.xy, ab.zw), c2.xy);
  c.crosses = c2.z != 0.0;
  c.texels = ivec4(rtwBentEntry(caster, 6));
  c.plane = vec3(e0.w, e1.w, anchor.z);
  c.depth = max(e2.w, 0.0);
  return c;
}

// Whether a line along one of the tile's sides separates the triangle from the tile.
bool rtwIsBeside(Covered c, Tile tile, vec2 side, vec2 other)
{
  vec2 across = vec2(side.y, -side.x);
  float reach = abs(dot(across, other)) + dot(abs(across), tile.stray + ROUNDING);
  vec3 away = vec3(dot(across, c.corners[0] - tile.middle), dot(across, c.corners[1] - tile.middle), dot(across, c.corners[2] - tile.middle));
  return min(min(away.x, away.y), away.z) > reach || max(max(away.x, away.y), away.z) < -reach;
}

// The least depth that the triangle can have in a tile.
float rtwNearestIn(Covered c, Tile tile)
{
  vec2 slope = c.plane.xy;
  float reach = abs(dot(slope, tile.alongX)) + abs(dot(slope, tile.alongY)) + dot(abs(slope), tile.stray);
  float onPlane = c.plane.z + dot(slope, tile.middle - c.anchor) - reach;
  return onPlane > c.depth ? onPlane : c.depth;
}

// Where a tile lies: -1 beside the triangle, 1 in it, 0 neither.
int rtwSideOf(Covered c, Tile tile)
{
  vec2 box = abs(tile.alongX) + abs(tile.alongY) + tile.stray + ROUNDING;
  if (any(greaterThan(tile.middle - box, c.high)) || any(lessThan(tile.middle + box, c.low)))
  {
    return -1;
  }
  vec2 away = tile.middle - c.anchor;
  float least = 1e30;
  float most = 1e30;
  for (int i = 0; i < 3; ++i)
  {
    vec3 edge = c.edges[i];
    float middle = dot(edge, vec3(away, 1.0));
    float reach = abs(dot(edge.xy, tile.alongX)) + abs(dot(edge.xy, tile.alongY)) + dot(abs(edge.xy), tile.stray);
    least = min(least, middle - reach);
    most = min(most, middle + reach);
  }
  bool beside = most < -ROUNDING ||
    (!c.crosses && (rtwIsBeside(c, tile, tile.alongX, tile.alongY) || rtwIsBeside(c, tile, tile.alongY, tile.alongX)));
  return beside ? -1 : least >= 0.0 ? 1 : 0;
}

// The bit at `place` if a texel's centre lies in the triangle, as the fragment shader decides it, else 0.
uint rtwHas(Covered c, ivec2 texel, uint place)
{
  vec3 away = vec3(rtwTexelCentre(rtwLayer, texel) - c.anchor, 1.0);
  return min(min(dot(c.edges[0], away), dot(c.edges[1], away)), dot(c.edges[2], away)) < -ROUNDING ? 0u : 1u << place;
}

uint rtwRowOf(Covered c, ivec2 texel)
{
  return rtwHas(c, texel, 0u) | rtwHas(c, texel + ivec2(1, 0), 1u) | rtwHas(c, texel + ivec2(2, 0), 2u) | rtwHas(c, texel + ivec2(3, 0), 3u);
}

// The texels of a tile of 4 x 4 whose centres the triangle hides: first and last, none if the last comes before the
// first.
ivec4 rtwTaken(Covered c, ivec2 first)
{
  uvec4 rows = uvec4(rtwRowOf(c, first), rtwRowOf(c, first + ivec2(0, 1)), rtwRowOf(c, first + ivec2(0, 2)), rtwRowOf(c, first + ivec2(0, 3)));
  uint columns = rows.x | rows.y | rows.z | rows.w;
  uint taken = uint(rows.x != 0u) | uint(rows.y != 0u) << 1 | uint(rows.z != 0u) << 2 | uint(rows.w != 0u) << 3;
  return first.xyxy + ivec4(findLSB(columns), findLSB(taken), findMSB(columns), findMSB(taken) - int(taken == 0u));
}

void rtwAddTexels(Covered c, ivec4 texels)
{
  texels = ivec4(max(texels.xy, c.texels.xy), min(texels.zw, c.texels.zw));
  if (any(greaterThan(texels.xy, texels.zw)))
  {
    return;
  }
  float texel = 1.0 / float(rtwWarpSize.y);
  vec2 low = vec2(texels.xy) * texel;
  vec2 high = vec2(texels.zw + 1) * texel;
  ivec2 size = texels.zw - texels.xy + 1;
  bool isPoint = max(size.x, size.y) <= rtwLargestPoint;
  // The first cluster's draw has all that aren't points.
  uint i = isPoint ? MOST_TILES - 1u - atomicAdd(rtwPointDraw[0], 1u) : atomicAdd(rtwWork[0].bentDraw[0], 6u) / 6u;
  rtwCovers[i].corners = vec2[3](low, isPoint ? vec2(size) : vec2(high.x, low.y), vec2(low.x, high.y));
  rtwCovers[i].caster = isPoint ? floatBitsToUint(float(c.caster)) : 2u * c.caster + 1u;
  rtwCovers[i].depth = c.depth;
}

uvec2 rtwTileToDo(uint caster, int level, ivec2 at)
{
  return uvec2(caster, uint(level) << 28 | uint(at.y) << 14 | uint(at.x));
}

void rtwAddTileToDo(uint list, uint place, uint caster, int level, ivec2 at)
{
  rtwTilesToDo[MOST_TILES * list + place] = rtwTileToDo(caster, level, at);
}
