// What there is to do with the tiles of a list, before it is done.
layout(local_size_x = 1) in;
uniform int rtwTileList;

void main()
{
  uint tiles = rtwTileCounts[rtwTileList];
  uint room = MOST_TILES - rtwWork[0].bentDraw[0] / 6u - rtwPointDraw[0] - tiles;
  rtwTileGroups[0] = (tiles + TILES_GROUP - 1u) / TILES_GROUP;
  rtwTileGroups[1] = 1u;
  rtwTileGroups[2] = 1u;
  if (rtwTileList != int(TAKEN_LIST))
  {
    room -= rtwTileCounts[TAKEN_LIST];
    rtwTileCounts[1 - rtwTileList] = 0u;
  }
  rtwTilesToDivide = room / 3u;
}
