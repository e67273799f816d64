// A tile of the list is divided into four, each of which becomes a cover, or none, or is put into the next list. Where there isn't room for
// that, the tile is a cover as it is.
layout(local_size_x = TILES_GROUP) in;
uniform int rtwTileList;

const uint NOWHERE = 0u;
const uint DIVIDED = 1u;
const uint TAKEN = 2u;
const uint COVER = 3u;
shared uint rtwCounts[4]; // of what becomes of the work group's, then where that begins

uint rtwFateOf(Covered c, int level, ivec2 at, bool isPart)
{
  Tile tile = rtwTile(rtwLayer, level, at);
  int side = rtwSideOf(c, tile);
  bool isUseful = isPart && side >= 0 && !rtwIsBehindAll(ivec4(at << level, ((at + 1) << level) - 1), rtwNearestIn(c, tile));
  uint divided = level > LEAST_TILE_LEVEL ? DIVIDED : TAKEN;
  return !isUseful ? NOWHERE : side > 0 ? COVER : divided;
}

void rtwAddPart(Covered c, int level, ivec2 at, uint fate, inout uint places[4])
{
  uint place = places[fate]++;
  if (fate == DIVIDED)
  {
    rtwAddTileToDo(uint(1 - rtwTileList), place, c.caster, level, at);
  }
  else if (fate == TAKEN)
  {
    rtwAddTileToDo(TAKEN_LIST, place, c.caster, 0, at << level);
  }
  else if (fate == COVER)
  {
    rtwAddTexels(c, ivec4(at << level, ((at + 1) << level) - 1));
  }
}

void main()
{
  uint i = gl_GlobalInvocationID.x;
  bool isUsed = i < rtwTileCounts[rtwTileList];
  uvec2 item = rtwTilesToDo[MOST_TILES * uint(rtwTileList) + (isUsed ? i : 0u)];
  Covered c = rtwLoadCovered(item.x);
  int level = int(item.y >> 28) - 1;
  ivec2 first = 2 * (ivec2(item.y, item.y >> 14) & 0x3fff);
  ivec4 range = c.texels >> level;
  bool isDivided = isUsed && i < rtwTilesToDivide;
  uint fates[4];
  uint places[4] = uint[4](0u, 0u, 0u, 0u); // how many there are of each
  for (int k = 0; k < 4; ++k)
  {
    ivec2 at = first + ivec2(k & 1, k >> 1);
    bool isPart = isDivided && all(greaterThanEqual(at, range.xy)) && all(lessThanEqual(at, range.zw));
    fates[k] = rtwFateOf(c, level, at, isPart);
    ++places[fates[k]];
  }
  if (gl_LocalInvocationIndex < 4u)
  {
    rtwCounts[gl_LocalInvocationIndex] = 0u;
  }
  barrier();
  places[DIVIDED] = atomicAdd(rtwCounts[DIVIDED], places[DIVIDED]);
  places[TAKEN] = atomicAdd(rtwCounts[TAKEN], places[TAKEN]);
  barrier();
  if (gl_LocalInvocationIndex == DIVIDED)
  {
    rtwCounts[DIVIDED] = atomicAdd(rtwTileCounts[1 - rtwTileList], rtwCounts[DIVIDED]);
  }
  if (gl_LocalInvocationIndex == TAKEN)
  {
    rtwCounts[TAKEN] = atomicAdd(rtwTileCounts[TAKEN_LIST], rtwCounts[TAKEN]);
  }
  barrier();
  places[DIVIDED] += rtwCounts[DIVIDED];
  places[TAKEN] += rtwCounts[TAKEN];
  for (int k = 0; k < 4; ++k)
  {
    rtwAddPart(c, level, first + ivec2(k & 1, k >> 1), fates[k], places);
  }
  if (isUsed && !isDivided)
  {
    rtwAddTexels(c, ivec4(first << level, ((first + 2) << level) - 1));
  }
}
