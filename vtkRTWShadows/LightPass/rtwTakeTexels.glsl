// Covers of a triangle in a square of 4 x 4 texels, which lie at its rim: as far as it takes them.
layout(local_size_x = TILES_GROUP) in;

void main()
{
  uint i = gl_GlobalInvocationID.x;
  if (i < rtwTileCounts[TAKEN_LIST])
  {
    uvec2 item = rtwTilesToDo[MOST_TILES * TAKEN_LIST + i];
    Covered c = rtwLoadCovered(item.x);
    rtwAddTexels(c, rtwTaken(c, ivec2(item.y, item.y >> 14) & 0x3fff));
  }
}
