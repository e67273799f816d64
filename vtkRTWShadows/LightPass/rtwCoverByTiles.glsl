// Covers of a bent triangle where the warp takes an axis to none: tiles of the map, found from the light plane. A pyramid knows where the
// centres of each tile's texels lie there; tiles are divided until one is in the triangle, beside it, or of
// 4 x 4 texels, whose centres are looked at.
const float ROUNDING = 1e-6;  // of the focus, not less than in rtwBentCasterFS.glsl
const uint MOST_TILES = MOST_COVERS - MOST_TRIANGLES;
const uint TILES_OF_A_SIZE = MOST_TILES / 6u;
const int MOST_STEPS = 30000; // on the way through tiles; llvmpipe ends loops after 65535

struct Covered
{
  Caster t;
  CasterPlane p;
  vec2 corners[3];
  uint caster;
  ivec4 texels; // that it can take: first, last
  float depth;
};

// Whether the triangle lies beside a tile, as one sees it along one of the tile's sides.
bool rtwIsBeside(Covered c, Tile tile, vec2 side, vec2 other)
{
  vec2 across = vec2(side.y, -side.x);
  float reach = abs(dot(across, other)) + dot(abs(across), tile.stray + ROUNDING);
  vec3 away = vec3(dot(across, c.corners[0] - tile.middle), dot(across, c.corners[1] - tile.middle), dot(across, c.corners[2] - tile.middle));
  return min(min(away.x, away.y), away.z) > reach || max(max(away.x, away.y), away.z) < -reach;
}

// -1 beside the triangle, 1 in it, 0 neither.
int rtwSideOf(Covered c, Tile tile)
{
  vec2 box = abs(tile.alongX) + abs(tile.alongY) + tile.stray + ROUNDING;
  if (any(greaterThan(tile.middle - box, c.t.high)) || any(lessThan(tile.middle + box, c.t.low)))
  {
    return -1;
  }
  vec2 away = tile.middle - c.p.anchor.xy;
  float least = 1e30;
  float most = 1e30;
  for (int i = 0; i < 3; ++i)
  {
    vec3 edge = c.p.edges[i];
    float middle = dot(edge, vec3(away, 1.0));
    float reach = abs(dot(edge.xy, tile.alongX)) + abs(dot(edge.xy, tile.alongY)) + dot(abs(edge.xy), tile.stray);
    least = min(least, middle - reach);
    most = min(most, middle + reach);
  }
  bool beside = most < -ROUNDING ||
    (!c.t.crosses && (rtwIsBeside(c, tile, tile.alongX, tile.alongY) || rtwIsBeside(c, tile, tile.alongY, tile.alongX)));
  return beside ? -1 : least >= 0.0 ? 1 : 0;
}

// Whether a texel's centre lies in the triangle, as the fragment shader decides it, as its place in a mask.
uint rtwHas(Covered c, ivec2 texel, uint place)
{
  vec3 away = vec3(rtwTexelCentre(rtwLayer, texel) - c.p.anchor.xy, 1.0);
  return min(min(dot(c.p.edges[0], away), dot(c.p.edges[1], away)), dot(c.p.edges[2], away)) < -ROUNDING ? 0u : 1u << place;
}

uint rtwRowOf(Covered c, ivec2 texel)
{
  return rtwHas(c, texel, 0u) | rtwHas(c, texel + ivec2(1, 0), 1u) | rtwHas(c, texel + ivec2(2, 0), 2u) | rtwHas(c, texel + ivec2(3, 0), 3u);
}

// The texels of a tile of 4 x 4 that it takes: first and last, none if the last comes before the first.
ivec4 rtwTaken(Covered c, ivec2 first)
{
  uvec4 rows = uvec4(rtwRowOf(c, first), rtwRowOf(c, first + ivec2(0, 1)), rtwRowOf(c, first + ivec2(0, 2)), rtwRowOf(c, first + ivec2(0, 3)));
  uint columns = rows.x | rows.y | rows.z | rows.w;
  uint taken = uint(rows.x != 0u) | uint(rows.y != 0u) << 1 | uint(rows.z != 0u) << 2 | uint(rows.w != 0u) << 3;
  return first.xyxy + ivec4(findLSB(columns), findLSB(taken), findMSB(columns), findMSB(taken) - int(taken == 0u));
}

void rtwAddTexels(Covered c, ivec4 texels)
{
  float texel = 1.0 / float(rtwWarpSize.y);
  rtwAddBox(c.caster, vec2(texels.xy) * texel, vec2(texels.zw + 1) * texel, c.depth);
}

// The tile, as far as it is between the texels; a small one, as far as it is taken. How many tiles there are of the cluster's triangles then.
uint rtwAddTile(Covered c, int level, ivec2 at, int side)
{
  bool whole = side > 0 || level > LEAST_TILE_LEVEL;
  ivec4 part = whole ? ivec4(at << level, ((at + 1) << level) - 1) : rtwTaken(c, at << level);
  part = ivec4(max(part.xy, c.texels.xy), min(part.zw, c.texels.zw));
  if (any(greaterThan(part.xy, part.zw)))
  {
    return 0u;
  }
  uint tiles = atomicAdd(rtwWork[gl_WorkGroupID.x].slices, 1u) + 1u;
  if (tiles <= MOST_TILES)
  {
    rtwAddTexels(c, part);
  }
  return tiles;
}

// Whether there was room for all the tiles between the texels. The more there are, the larger are those at the triangle's rim.
bool rtwAddTiles(Covered c, int top)
{
  ivec4 tops = c.texels >> top;
  int level = top;
  int least = LEAST_TILE_LEVEL;
  ivec2 at = tops.xy;
  uint tiles = 0u;
  int steps = 0;
  for (; steps < MOST_STEPS && tiles <= MOST_TILES && at.y >> (top - level) <= tops.w; ++steps)
  {
    int side = rtwSideOf(c, rtwTile(rtwLayer, level, at));
    if (side == 0 && level > least)
    {
      --level;
      at *= 2;
      continue;
    }
    if (side >= 0)
    {
      tiles = max(tiles, rtwAddTile(c, level, at, side));
      least = LEAST_TILE_LEVEL + int(tiles / TILES_OF_A_SIZE);
    }
    // The next one on the way through all four of a larger one: along x, then along y, then up, by as many levels as both end in ones.
    int up = min(findLSB(~(at.x & at.y)), top - level);
    level += up;
    at >>= up;
    at = level < top ? ((at.x & 1) == 0 ? at + ivec2(1, 0) : at + ivec2(-1, 1))
                     : at.x < tops.z ? at + ivec2(1, 0) : ivec2(tops.x, at.y + 1);
  }
  return steps < MOST_STEPS && tiles <= MOST_TILES;
}

void rtwCover(Caster t, CasterPlane p, uint caster, vec2 u[3], vec2 bend)
{
  Covered c;
  c.t = t;
  c.p = p;
  c.caster = caster;
  c.depth = max(t.depths.x, 0.0);
  c.texels = rtwTexels(rtwBoundsOnMap(rtwLayer, t.low, t.high));
  for (int k = 0; k < 3; ++k)
  {
    c.corners[k] = t.points[k].xy / t.points[k].w;
  }
  ivec2 size = c.texels.zw - c.texels.xy + 1;
  int top = max(findMSB(max(max(size.x, size.y) - 1, 1)) + 1, LEAST_TILE_LEVEL);
  if (!rtwAddTiles(c, top))
  {
    rtwAddTexels(c, c.texels);
  }
}
