// Backward analysis (Rosen 2012, section 4.1): a work group collects a tile of view samples, then adds what it found.
const int MOST_CELLS = 2048;
const float MOST_PARTS = 8.0; // parts that a sample's square is divided into along an axis
shared uint rtwTile[PROFILES * 2 * MOST_CELLS];

void rtwAdd(int profile, ivec2 cell, uvec2 value)
{
  int first = 2 * profile * MOST_CELLS;
  atomicAdd(rtwTile[first + cell.x], value.x);
  atomicAdd(rtwTile[first + MOST_CELLS + cell.y], value.y);
}

// What a sample asks for as a whole number, divided among cells without losing any of it.
struct Share
{
  vec2 whole;
  uvec2 given;
};

uvec2 rtwNextOf(inout Share share, float upTo)
{
  uvec2 given = share.given;
  share.given = uvec2(share.whole * upTo + 0.5);
  return share.given - given;
}

void rtwCollect(ivec2 cell, uvec2 value, bool edge)
{
  if (!rtwIsSum())
  {
    atomicMax(rtwTile[cell.x], value.x);
    atomicMax(rtwTile[MOST_CELLS + cell.y], value.y);
    return;
  }
  rtwAdd(0, cell, value);
  if (PROFILES == 2 && edge)
  {
    rtwAdd(PROFILES - 1, cell, value);
  }
}

// Spreads a sample's square of pixels over the cells that the pixels would fall to.
void rtwVisit(LitSample s)
{
  vec4 focus = rtwFocus(rtwLayer);
  bool edge = !rtwIsOn(SHADOW_EDGE) || rtwAtShadowEdge(s, focus);
  vec2 asked = rtwAsked(s, focus, edge);
  vec2 least = vec2(greaterThan(asked, vec2(0.0)));
  Share share = Share(floor(clamp(asked, least, vec2(LARGEST)) + 0.5), uvec2(0u));
  vec2 wide = rtwStride > 1 ? float(rtwStride) * s.footprint * focus.yw : vec2(0.0);
  vec2 cells = wide * float(rtwWarpSize.x);
  int parts = int(clamp(ceil(max(cells.x, cells.y)), 1.0, MOST_PARTS));
  for (int part = 0; part < parts; ++part)
  {
    float before = float(part) / float(parts);
    float after = float(part + 1) / float(parts);
    vec2 shift = wide * (0.5 * (before + after) - 0.5);
    uvec2 value = rtwIsSum() ? rtwNextOf(share, after) : floatBitsToUint(asked);
    rtwCollect(rtwCell(rtwFocused(focus, s.onLight) + shift), value, edge);
  }
}

void rtwFlush(int profile, int axis, int cell)
{
  uint value = rtwTile[(2 * profile + axis) * MOST_CELLS + cell];
  uint at = rtwPlace(profile, axis, cell);
  if (value != 0u && rtwIsSum())
  {
    rtwAddToProfile(at, value, 0u);
  }
  else if (value != 0u)
  {
    atomicMax(rtwProfile[at], value);
  }
}

void main()
{
  uint me = gl_LocalInvocationIndex;
  for (uint i = me; i < uint(PROFILES * 2 * MOST_CELLS); i += 256u)
  {
    rtwTile[i] = 0u;
  }
  barrier();
  rtwVisitTile();
  barrier();
  for (int i = int(me); i < PROFILES * 2 * rtwWarpSize.x; i += 256)
  {
    int column = i / rtwWarpSize.x;
    rtwFlush(column / 2, column % 2, i % rtwWarpSize.x);
  }
}
