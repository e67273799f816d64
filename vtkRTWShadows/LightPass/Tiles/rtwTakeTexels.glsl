// Writes the covers of a triangle: tiles that lie in it and, of a square of 4 x 4 texels at its rim, the part whose
// centres it hides.
layout(local_size_x = TILES_GROUP) in;

void main()
{
  uint i = gl_GlobalInvocationID.x;
  if (i < rtwTileCounts[TAKEN_LIST])
  {
    uvec2 item = rtwTilesToDo[MOST_TILES * TAKEN_LIST + i];
    Covered c = rtwLoadCovered(item.x);
    int level = int(item.y >> 28);
    ivec2 at = ivec2(item.y, item.y >> 14) & 0x3fff;
    ivec4 taken = rtwTaken(c, level == 0 ? at : at << level);
    rtwAddTexels(c, level == 0 ? taken : ivec4(at << level, ((at + 1) << level) - 1));
  }
}
