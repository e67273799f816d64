// A level of the tiles of the map; a tile further up holds four.
layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 2) buffer Bends
{
  vec4 rtwTiles[]; // as Tile
};
uniform int rtwLayer;
uniform int rtwLevel;

Tile rtwTileOfTexels(ivec2 at)
{
  ivec2 first = at << LEAST_TILE_LEVEL;
  ivec2 last = min(first + (1 << LEAST_TILE_LEVEL), rtwWarpSize.yy) - 1;
  vec2 a = rtwTexelCentre(rtwLayer, first);
  vec2 b = rtwTexelCentre(rtwLayer, ivec2(last.x, first.y));
  vec2 c = rtwTexelCentre(rtwLayer, ivec2(first.x, last.y));
  vec2 d = rtwTexelCentre(rtwLayer, last);
  Tile tile = Tile(0.25 * (a + b + c + d), vec2(0.0), 0.25 * (b - a + d - c), 0.25 * (c - a + d - b));
  vec2 extent = 0.5 * vec2(last - first);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      vec2 share = (vec2(x - first.x, y - first.y) - extent) / max(extent, 0.5);
      vec2 away = rtwTexelCentre(rtwLayer, ivec2(x, y)) - tile.middle;
      tile.stray = max(tile.stray, abs(away - share.x * tile.alongX - share.y * tile.alongY));
    }
  }
  return tile;
}

Tile rtwTileStored(ivec2 at)
{
  int place = rtwTilePlace(rtwLayer, rtwLevel - 1, at);
  return Tile(rtwTiles[place].xy, rtwTiles[place].zw, rtwTiles[place + 1].xy, rtwTiles[place + 1].zw);
}

Tile rtwTileOfFour(ivec2 at)
{
  ivec2 first = 2 * at;
  bvec2 alone = equal(first, ivec2(rtwTileSide(rtwLevel - 1) - 1)); // at the end there are two, or one
  Tile parts[4];
  Tile tile = Tile(vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));
  for (int k = 0; k < 4; ++k)
  {
    parts[k] = rtwTileStored(first + ivec2(alone.x ? 0 : k % 2, alone.y ? 0 : k / 2));
    tile.middle += 0.25 * parts[k].middle;
    tile.alongX += 0.25 * (parts[k].alongX + (k % 2 == 0 ? -1.0 : 1.0) * parts[k].middle);
    tile.alongY += 0.25 * (parts[k].alongY + (k / 2 == 0 ? -1.0 : 1.0) * parts[k].middle);
  }
  // Distances in texels: from a part's middle to its last texel centre, and from the tile's middle to a part's.
  float part = 0.5 * float((1 << (rtwLevel - 1)) - 1);
  float apart = 0.5 * float(1 << (rtwLevel - 1));
  vec2 share = vec2(alone.x ? 1.0 : part / (part + apart), alone.y ? 1.0 : part / (part + apart));
  for (int k = 0; k < 4; ++k)
  {
    vec2 at = (1.0 - share) * vec2(k % 2 == 0 ? -1.0 : 1.0, k / 2 == 0 ? -1.0 : 1.0);
    vec2 away = abs(parts[k].middle - tile.middle - at.x * tile.alongX - at.y * tile.alongY) +
      abs(parts[k].alongX - share.x * tile.alongX) + abs(parts[k].alongY - share.y * tile.alongY);
    tile.stray = max(tile.stray, parts[k].stray + away);
  }
  return tile;
}

void main()
{
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(at, ivec2(rtwTileSide(rtwLevel)))))
  {
    Tile tile = rtwLevel == LEAST_TILE_LEVEL ? rtwTileOfTexels(at) : rtwTileOfFour(at);
    int place = rtwTilePlace(rtwLayer, rtwLevel, at);
    rtwTiles[place] = vec4(tile.middle, tile.stray);
    rtwTiles[place + 1] = vec4(tile.alongX, tile.alongY);
  }
}
