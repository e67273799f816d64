// The tiles, four at most, that hold the texels whose centres a bent triangle can hide, or all their squares of 4 x 4
// texels where those are few.
layout(local_size_x = SET_UP_GROUP) in;
const int FEW_SQUARES = 8; // squares that it costs less to look at than to divide tiles down to

void main()
{
  uint cluster = gl_WorkGroupID.x;
  for (uint i = gl_LocalInvocationID.x; i < rtwWork[cluster].numberOfCasters; i += gl_WorkGroupSize.x)
  {
    uint triangle = rtwWork[cluster].casters[i];
    if (triangle < IS_COVERED)
    {
      continue;
    }
    Covered c = rtwLoadCovered(MOST_TRIANGLES * cluster + triangle - IS_COVERED);
    ivec2 size = c.texels.zw - c.texels.xy + 1;
    ivec2 squares = (size + (1 << LEAST_TILE_LEVEL) - 1) >> LEAST_TILE_LEVEL;
    int few = squares.x * squares.y;
    if (few <= FEW_SQUARES)
    {
      uint place = atomicAdd(rtwTileCounts[TAKEN_LIST], uint(few));
      for (int k = 0; k < few; ++k)
      {
        ivec2 at = ivec2(k % squares.x, k / squares.x) << LEAST_TILE_LEVEL;
        rtwAddTileToDo(TAKEN_LIST, place + uint(k), c.caster, 0, c.texels.xy + at);
      }
    }
    else
    {
      int level = findMSB(max(size.x, size.y) - 1) + 1;
      ivec2 first = c.texels.xy >> level;
      ivec2 count = (c.texels.zw >> level) - first + 1;
      uint place = atomicAdd(rtwTileCounts[0], uint(count.x * count.y));
      for (int k = 0; k < count.x * count.y; ++k)
      {
        rtwAddTileToDo(0u, place + uint(k), c.caster, level, first + ivec2(k % count.x, k / count.x));
      }
    }
  }
}
