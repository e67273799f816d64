// Backward analysis (Rosen 2012, section 4.1): a work group collects a tile of view samples, then adds what it found.
const int MOST_CELLS = 2048;
shared uint rtwTile[PROFILES * 2 * MOST_CELLS];

void rtwAdd(int profile, ivec2 cell, uvec2 value)
{
  int first = 2 * profile * MOST_CELLS;
  atomicAdd(rtwTile[first + cell.x], value.x);
  atomicAdd(rtwTile[first + MOST_CELLS + cell.y], value.y);
}

void rtwVisit(LitSample s)
{
  vec4 focus = rtwFocus(rtwLayer);
  ivec2 cell = rtwCell(s, focus);
  bool edge = !rtwIsOn(SHADOW_EDGE) || rtwAtShadowEdge(s, focus);
  vec2 asked = rtwAsked(s, focus, edge);
  if (rtwIsSum())
  {
    vec2 least = vec2(greaterThan(asked, vec2(0.0)));
    uvec2 value = uvec2(clamp(asked, least, vec2(LARGEST)) + 0.5);
    rtwAdd(0, cell, value);
    if (PROFILES == 2 && edge)
    {
      rtwAdd(PROFILES - 1, cell, value);
    }
  }
  else
  {
    atomicMax(rtwTile[cell.x], floatBitsToUint(asked.x));
    atomicMax(rtwTile[MOST_CELLS + cell.y], floatBitsToUint(asked.y));
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
