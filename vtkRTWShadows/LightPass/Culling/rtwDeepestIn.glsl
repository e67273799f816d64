// Whether a caster lies behind all view samples that look up a part of the map: it shadows nothing that is seen.
layout(binding = 8) uniform samplerBuffer rtwDeepest;
uniform int rtwHasDeepest; // 0 where receivers may be anywhere

float rtwDeepestOf(int level, ivec2 square)
{
  return texelFetch(rtwDeepest, rtwDeepestPlace(rtwWarpSize.y, level, square)).r;
}

// The depth of the deepest sample that looks up any of these texels, given by the first and the last. Up to four
// squares hold them.
float rtwDeepestIn(ivec4 texels)
{
  ivec4 squares = clamp(texels, 0, rtwWarpSize.y - 1) >> rtwSquare;
  ivec2 extent = squares.zw - squares.xy;
  int most = max(extent.x, extent.y);
  int level = most <= 1 ? 0 : findMSB(most - 1) + 1;
  squares >>= level;
  return max(max(rtwDeepestOf(level, squares.xy), rtwDeepestOf(level, squares.zw)),
    max(rtwDeepestOf(level, squares.xw), rtwDeepestOf(level, squares.zy)));
}

bool rtwIsBehindAll(ivec4 texels, float nearest)
{
  return rtwHasDeepest != 0 && nearest > rtwDeepestIn(texels);
}

// Whether a caster whose nearest depth is that lies behind all samples of a tile of 2^level texels a side.
bool rtwIsBehindTile(int level, ivec2 tile, float nearest)
{
  int square = max(level, rtwSquare);
  return rtwHasDeepest != 0 && nearest > rtwDeepestOf(square - rtwSquare, tile >> (square - level));
}
