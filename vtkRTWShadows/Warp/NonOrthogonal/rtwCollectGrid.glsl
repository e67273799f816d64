// What view samples ask for along one axis, in each cell of the grid: counted as they fall (Milet et al. 2015, steps 2 and 6), or, as demand,
// by one over their footprint. A sample's square is spread over the cells that its pixels would fall to.
const float MOST_PARTS = 8.0;
uniform int rtwFirst;      // where the sums of the axis begin, in cells
uniform int rtwLineLength; // cells from the beginning of a line to that of the next
uniform int rtwAxis; // along t samples lie where the functions along s put them

ivec2 rtwCellAndLine(vec2 q)
{
  float along = rtwAxis == 0 ? q.x : q.y;
  float across = rtwAxis == 0 ? q.y : rtwWarpAlong(rtwLayer, 0, q.x, q.y);
  return rtwCell(vec2(along, across));
}

void rtwVisit(LitSample s)
{
  vec4 focus = rtwFocus(rtwLayer);
  float asked = clamp(rtwAsked(s, focus, true)[rtwAxis], 1.0, LARGEST);
  vec2 wide = rtwStride > 1 ? float(rtwStride) * s.footprint * focus.yw : vec2(0.0);
  vec2 cells = wide * float(rtwWarpSize.x);
  float parts = clamp(ceil(max(cells.x, cells.y)), 1.0, MOST_PARTS);
  vec2 q = rtwFocused(focus, s.onLight);
  uint given = 0u;
  for (float part = 0.5; part < parts; part += 1.0)
  {
    ivec2 at = rtwCellAndLine(clamp(q + wide * (part / parts - 0.5), 0.0, 1.0));
    uint next = uint(asked * (part + 0.5) / parts + 0.5);
    rtwAddToProfile(2u * uint(rtwFirst + at.y * rtwLineLength + at.x), next - given, 0u);
    given = next;
  }
}

void main()
{
  rtwVisitTile();
}
