// A tile of the list is divided into four, each of which is left out, put into the next list, or into that of what is taken. Where there
// isn't room for that, the tile is taken as it is.
//
// What four tiles become is kept in bits, and there is one place where any is written: in software a write costs as much where nothing
// is written.
layout(local_size_x = TILES_GROUP) in;
uniform int rtwTileList;

const uint NOWHERE = 0u;
const uint DIVIDED = 1u;
const uint TAKEN = 2u;
shared uint rtwCounts[3]; // places in both lists where the work group's results begin, and how many they are

uint rtwFateOf(Covered c, int level, ivec2 at, bool isPart)
{
  Tile tile = rtwTile(rtwLayer, level, at);
  int side = rtwSideOf(c, tile);
  bool isUseful = isPart && side >= 0 && !rtwIsBehindTile(level, at, rtwNearestIn(c, tile));
  return !isUseful ? NOWHERE : side > 0 || level == LEAST_TILE_LEVEL ? TAKEN + 4u * uint(side) : DIVIDED;
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
  uint fates = isUsed && !isDivided ? TAKEN + 8u : NOWHERE; // four bits for each of the four tiles
  uvec2 counts = uvec2(0u, uint(fates != 0u));
  for (int k = 0; k < 4; ++k)
  {
    ivec2 at = first + ivec2(k & 1, k >> 1);
    bool isPart = isDivided && all(greaterThanEqual(at, range.xy)) && all(lessThanEqual(at, range.zw));
    uint fate = rtwFateOf(c, level, at, isPart);
    fates |= fate << (4 * k);
    counts += uvec2(fate & 1u, (fate >> 1) & 1u);
  }
  // Both counts fit in one number.
  if (gl_LocalInvocationIndex == 0u)
  {
    rtwCounts[2] = 0u;
  }
  barrier();
  uint before = atomicAdd(rtwCounts[2], counts.x | counts.y << 16);
  barrier();
  if (gl_LocalInvocationIndex < 2u)
  {
    uint list = gl_LocalInvocationIndex == 0u ? uint(1 - rtwTileList) : TAKEN_LIST;
    uint all = (rtwCounts[2] >> (16u * gl_LocalInvocationIndex)) & 0xffffu;
    rtwCounts[gl_LocalInvocationIndex] = MOST_TILES * list + atomicAdd(rtwTileCounts[list], all);
  }
  barrier();
  uvec2 places = uvec2(rtwCounts[0] + (before & 0xffffu), rtwCounts[1] + (before >> 16));
  while (fates != 0u)
  {
    int k = findLSB(fates) >> 2;
    uint fate = (fates >> (4 * k)) & 15u;
    fates &= ~(15u << (4 * k));
    bool isTaken = (fate & TAKEN) != 0u;
    bool isWhole = fate > 3u;
    ivec2 at = fate > 7u ? first >> 1 : first + ivec2(k & 1, k >> 1);
    int size = fate > 7u ? level + 1 : level;
    if (fate != NOWHERE)
    {
      rtwTilesToDo[isTaken ? places.y : places.x] = rtwTileToDo(c.caster, isTaken && !isWhole ? 0 : size, isTaken && !isWhole ? at << size : at);
      places += isTaken ? uvec2(0u, 1u) : uvec2(1u, 0u);
    }
  }
}
