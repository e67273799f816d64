// What there is to do with the tiles of a list, before it is done.
layout(local_size_x = 1) in;
uniform int rtwTileList;

void main()
{
  uint tiles = rtwTileCounts[rtwTileList];
  rtwTileGroups[0] = (tiles + TILES_GROUP - 1u) / TILES_GROUP;
  rtwTileGroups[1] = 1u;
  rtwTileGroups[2] = 1u;
  if (rtwTileList != int(TAKEN_LIST))
  {
    // Each tile that is divided may take three places more than it has.
    rtwTilesToDivide = (MOST_TILES - tiles - rtwTileCounts[TAKEN_LIST]) / 3u;
    rtwTileCounts[1 - rtwTileList] = 0u;
  }
}
