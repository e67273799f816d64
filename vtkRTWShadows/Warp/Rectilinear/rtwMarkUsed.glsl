// Marks the cells that view samples lie in, as far as a filter reaches.
layout(local_size_x = 16, local_size_y = 16) in;
uniform int rtwLayer;
uniform float rtwFilterWidth; // in world units
uniform vec4 rtwUnsampled;    // bounds on the light plane of receivers that aren't among the samples; empty if low exceeds high
shared uint rtwMarked[GRID * GRID_WORDS];

// The share of the focus by which rounding may displace a receiver.
const float ROUNDING = 1e-5;

void rtwMark(vec2 low, vec2 high)
{
  ivec2 first = clamp(ivec2(floor((low - ROUNDING) * float(GRID))), 0, GRID - 1);
  ivec2 last = clamp(ivec2(floor((high + ROUNDING) * float(GRID))), 0, GRID - 1);
  for (int row = first.y; row <= last.y; ++row)
  {
    for (int word = first.x / 32; word <= last.x / 32; ++word)
    {
      uint bits = rtwBitsBetween(word, first.x, last.x);
      int place = row * GRID_WORDS + word;
      if ((rtwMarked[place] & bits) != bits)
      {
        atomicOr(rtwMarked[place], bits);
      }
    }
  }
}

void rtwVisit(LitSample s)
{
  vec4 focus = rtwFocus(rtwLayer);
  vec2 at = rtwFocused(focus, s.onLight);
  vec2 reach = rtwFilterWidth / s.w * focus.yw;
  rtwMark(at - reach, at + reach);
}

void main()
{
  int me = int(gl_LocalInvocationIndex);
  for (int i = me; i < GRID * GRID_WORDS; i += 256)
  {
    rtwMarked[i] = 0u;
  }
  barrier();
  if (me == 0 && gl_WorkGroupID.xy == uvec2(0u) && all(lessThanEqual(rtwUnsampled.xy, rtwUnsampled.zw)))
  {
    vec4 focus = rtwFocus(rtwLayer);
    rtwMark(rtwFocused(focus, rtwUnsampled.xy), rtwFocused(focus, rtwUnsampled.zw));
  }
  rtwVisitTile();
  barrier();
  for (int i = me; i < GRID * GRID_WORDS; i += 256)
  {
    if (rtwMarked[i] != 0u)
    {
      atomicOr(rtwUsedCells[rtwUsedPlace(rtwLayer, 0) + i], rtwMarked[i]);
    }
  }
}
