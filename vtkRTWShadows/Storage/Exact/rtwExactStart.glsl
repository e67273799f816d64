// Where in the grid the search for a box's samples starts: at up to four squares, as small as hold all of it.
uniform int rtwLayer;

struct GridStart
{
  int level;
  uvec2 first;
  uvec2 last;
};

const float START_MARGIN = 0.02; // a share of a texel, for rounding

GridStart rtwStartOf(vec2 low, vec2 high)
{
  vec4 focus = rtwFocus(rtwLayer);
  float side = float(rtwGridSide);
  vec4 box = rtwBoundsOnMap(rtwLayer, rtwFocused(focus, low), rtwFocused(focus, high)) * side;
  ivec2 first = ivec2(clamp(floor(box.xy - START_MARGIN), 0.0, side - 1.0));
  ivec2 last = ivec2(clamp(floor(box.zw + START_MARGIN), vec2(first), vec2(side - 1.0)));
  int extent = max(last.x - first.x, last.y - first.y);
  int level = extent <= 1 ? 0 : findMSB(extent - 1) + 1;
  return GridStart(level, uvec2(first >> level), uvec2(last >> level));
}

uint rtwStartNode(GridStart start, uint x, uint y)
{
  return rtwLevelStart(start.level) + rtwMorton(uvec2(x, y));
}
