// Covers of a bent triangle, the cheapest of two that hold all of it. One is the straight triangle, its edges moved out by as much as the
// warp can bend. The other is a stack of slices, bands of rows or columns, each as wide as the triangle is there: the warp is separable
// and monotone, so that it takes an interval on the light plane to one on the map.

const int FEW_SLICES = 4; // slices that there is always room for
const uint MOST_SLICES = MOST_COVERS - uint(FEW_SLICES) * MOST_TRIANGLES;
const float ROUNDING = 1e-6;   // a share of a coordinate
const int BLOCK = 4;           // texels a side
const float SLICE_COST = 33.0; // the cost of a cover, in fragments

// Moves the triangle's edges out by as much as a box with the half sides `by` reaches beyond them.
void rtwGrow(inout vec2 u[3], vec2 by)
{
  float turn = (u[1].x - u[0].x) * (u[2].y - u[0].y) - (u[1].y - u[0].y) * (u[2].x - u[0].x) < 0.0 ? -1.0 : 1.0;
  vec3 lines[3];
  for (int i = 0; i < 3; ++i)
  {
    vec2 along = u[(i + 1) % 3] - u[i];
    vec2 out_ = turn * vec2(along.y, -along.x) / max(length(along), 1e-20);
    lines[i] = vec3(out_, dot(out_, u[i]) + dot(abs(out_), by));
  }
  for (int i = 0; i < 3; ++i)
  {
    vec3 a = lines[(i + 2) % 3];
    vec3 b = lines[i];
    float d = a.x * b.y - a.y * b.x;
    u[i] = vec2(a.z * b.y - a.y * b.z, a.x * b.z - a.z * b.x) / d;
  }
}

// The area of a triangle on the map, in texels.
float rtwArea(vec2 u[3])
{
  vec2 a = (u[1] - u[0]) * float(rtwWarpSize.y);
  vec2 b = (u[2] - u[0]) * float(rtwWarpSize.y);
  float area = 0.5 * abs(a.x * b.y - a.y * b.x);
  return area < 1e30 ? area : 1e30; // 1e30 also where it is not a number
}

// What the triangle spans along one axis while it is in an interval of the other, with room for rounding.
vec2 rtwSpan(Caster t, int along, float from, float to)
{
  int across = 1 - along;
  vec2 span = vec2(1e30, -1e30);
  float most = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    vec2 a = t.points[i].xy / t.points[i].w;
    vec2 b = t.points[(i + 1) % 3].xy / t.points[(i + 1) % 3].w;
    float step = b[across] - a[across];
    vec2 f = step == 0.0 ? vec2(0.0, 1.0) : clamp((vec2(from, to) - a[across]) / step, 0.0, 1.0);
    if (max(a[across], b[across]) >= from && min(a[across], b[across]) <= to)
    {
      vec2 ends = a[along] + f * (b[along] - a[along]);
      span = vec2(min(span.x, min(ends.x, ends.y)), max(span.y, max(ends.x, ends.y)));
    }
    most = max(most, max(abs(a[along]), abs(a[across])));
  }
  return span + ROUNDING * (1.0 + most) * vec2(-1.0, 1.0);
}

float rtwCentre(int axis, int texel)
{
  return rtwTexelCentre(rtwLayer, ivec2(texel))[axis];
}

// The first texel of a slice, which lies between blocks of texels: rasterizers go block by block, so that a block that
// two slices share is shaded twice.
int rtwSliceStart(int first, int count, int k, int slices)
{
  int start = first + count * k / slices;
  return k == 0 || k == slices ? start : max(start & ~(BLOCK - 1), first);
}

// Bands of texels along one axis, each as long as the triangle is there.
void rtwAddSlices(Caster t, uint caster, ivec4 texels, int slices, float depth)
{
  int along = texels.z - texels.x < texels.w - texels.y ? 0 : 1;
  int across = 1 - along;
  int first = texels[across];
  int count = texels[2 + across] - first + 1;
  float texel = 1.0 / float(rtwWarpSize.y);
  for (int k = 0; k < slices; ++k)
  {
    int from = rtwSliceStart(first, count, k, slices);
    int end = rtwSliceStart(first, count, k + 1, slices);
    float rounding = ROUNDING * (1.0 + max(abs(t.low[across]), abs(t.high[across])));
    vec2 span = rtwSpan(t, along, rtwCentre(across, from) - rounding, rtwCentre(across, end - 1) + rounding);
    if (span.x > span.y || end == from)
    {
      continue;
    }
    vec2 low = vec2(float(from) * texel);
    vec2 high = vec2(float(end) * texel);
    low[along] = max(rtwWarp(rtwLayer, vec2(span.x))[along] - MARGIN * texel, 0.0);
    high[along] = min(rtwWarp(rtwLayer, vec2(span.y))[along] + MARGIN * texel, 1.0);
    if (low[along] < high[along])
    {
      rtwAddBox(caster, low, high, depth);
    }
  }
}

// u: its corners on the map.
void rtwCover(Caster t, uint place, uint caster, vec2 u[3], vec2 bend)
{
  float depth = max(t.depths.x, 0.0);
  float texel = 1.0 / float(rtwWarpSize.y);
  ivec4 texels = rtwTexels(rtwBoundsOnMap(rtwLayer, t.low, t.high));
  vec2 size = vec2(texels.zw - texels.xy + 1);
  float box = size.x * size.y;
  if (t.crosses)
  {
    rtwAddBox(caster, vec2(texels.xy) * texel, vec2(texels.zw + 1) * texel, depth);
    return;
  }
  int slices = clamp(int(sqrt(box / SLICE_COST)), 1, int(max(size.x, size.y)));
  vec2 grown[3] = u;
  rtwGrow(grown, bend + MARGIN * texel);
  if (rtwArea(grown) + SLICE_COST <= min(rtwArea(u), box) + box / float(slices) + SLICE_COST * float(slices))
  {
    rtwAddCover(2u * caster, grown[0], grown[1], grown[2], depth);
    return;
  }
  if (slices > FEW_SLICES && atomicAdd(rtwWork[gl_WorkGroupID.x].slices, uint(slices)) + uint(slices) > MOST_SLICES)
  {
    slices = FEW_SLICES;
  }
  rtwAddSlices(t, caster, texels, slices, depth);
}
