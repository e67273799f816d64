// Curved rasterization: a cover of the warped triangle, in which each fragment decides in unwarped light space.
//
// The cover is the smallest of three that hold all of it: its bounds on the map, which are the images of its bounds on the light plane
// because the warp is separable and monotone; the straight triangle, its edges moved out by as much as the warp can bend;
// and the straight triangle's box along its longest edge, grown likewise. Edges and plane are homogeneous (Olano and Greer 1997), so that a triangle that
// reaches behind a spot needs no clipping but for its bounds.
layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;
in vec4 focusedPoint[];
flat out vec3 edges[3];    // signed distance from each at (q - anchor, 1)
flat out vec3 anchor;      // a corner: q and depth
flat out vec2 slope;       // of depth from there
flat out vec2 depthRange;
flat out int bent;
uniform int rtwLayer;
uniform float rtwNearestW;
uniform float rtwAllowedBend;

const float MARGIN = 0.02; // of a texel, for rounding

// What every vertex carries: outputs don't outlive an EmitVertex.
vec3 myEdges[3];
vec3 myAnchor;
vec2 mySlope;
vec2 myDepthRange;
int myBent = 0;

// Relative to the corner that is farthest from the light: differences of large numbers would leave nothing of a small triangle.
bool rtwSetUp()
{
  int a = focusedPoint[1].w > focusedPoint[0].w ? 1 : 0;
  a = focusedPoint[2].w > focusedPoint[a].w ? 2 : a;
  if (focusedPoint[a].w < rtwNearestW)
  {
    return false; // wholly behind the light
  }
  myAnchor = focusedPoint[a].xyz / focusedPoint[a].w;
  vec4 h[3]; // homogeneous, the anchor at the origin
  for (int i = 0; i < 3; ++i)
  {
    vec4 p = focusedPoint[i];
    h[i] = i == a ? vec4(0.0, 0.0, 0.0, p.w) : vec4(p.xyz - myAnchor * p.w, p.w);
  }
  vec4 b = h[(a + 1) % 3];
  vec4 c = h[(a + 2) % 3];
  float area = b.x * c.y - b.y * c.x;
  mySlope = vec2(b.z * c.y - b.y * c.z, b.x * c.z - b.z * c.x) / area;
  if (!(abs(mySlope.x) + abs(mySlope.y) < 1e30))
  {
    return false; // seen edge on
  }
  for (int i = 0; i < 3; ++i)
  {
    vec3 e = cross(h[(i + 1) % 3].xyw, h[(i + 2) % 3].xyw);
    myEdges[i] = e * (area < 0.0 ? -1.0 : 1.0) / max(length(e.xy), 1e-30);
  }
  return true;
}

// Of the part that is not behind the light: q low, q high. False where none is left or all of it lies beside the map.
bool rtwBounds(out vec4 bounds, out bool crosses)
{
  vec2 low = vec2(1e30);
  vec2 high = vec2(-1e30);
  uint outside = 15u;
  crosses = false;
  myDepthRange = vec2(1e30, -1e30);
  for (int i = 0; i < 3; ++i)
  {
    vec4 a = focusedPoint[i];
    vec4 b = focusedPoint[(i + 1) % 3];
    outside &= (a.x < 0.0 ? 1u : 0u) | (a.x > a.w ? 2u : 0u) | (a.y < 0.0 ? 4u : 0u) | (a.y > a.w ? 8u : 0u);
    if (a.w >= rtwNearestW)
    {
      low = min(low, a.xy / a.w);
      high = max(high, a.xy / a.w);
      myDepthRange = vec2(min(myDepthRange.x, a.z / a.w), max(myDepthRange.y, a.z / a.w));
    }
    if ((a.w < rtwNearestW) != (b.w < rtwNearestW))
    {
      vec4 p = mix(a, b, (rtwNearestW - a.w) / (b.w - a.w)) / rtwNearestW;
      low = min(low, p.xy);
      high = max(high, p.xy);
      myDepthRange = vec2(min(myDepthRange.x, p.z), max(myDepthRange.y, p.z));
      crosses = true;
    }
  }
  bounds = vec4(low, high);
  return outside == 0u && low.x <= high.x;
}

void rtwEmit(vec2 onMap, float depth)
{
  edges = myEdges;
  anchor = myAnchor;
  slope = mySlope;
  depthRange = myDepthRange;
  bent = myBent;
  gl_Position = vec4(2.0 * onMap - 1.0, 2.0 * depth - 1.0, 1.0);
  EmitVertex();
}

// The triangle whose edges lie farther out by what a box of half that size reaches beyond them.
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

float rtwArea(vec2 u[3])
{
  vec2 a = u[1] - u[0];
  vec2 b = u[2] - u[0];
  float area = 0.5 * abs(a.x * b.y - a.y * b.x);
  return area < 1e30 ? area : 1e30; // not a number either
}

void main()
{
  vec4 bounds;
  bool crosses;
  if (!rtwSetUp() || !rtwBounds(bounds, crosses))
  {
    return;
  }
  float texel = 1.0 / float(rtwWarpSize.y);
  vec2 bend = vec2(rtwBend(rtwLayer, 0, bounds.x, bounds.z), rtwBend(rtwLayer, 1, bounds.y, bounds.w));
  vec2 u[3];
  float nearest = max(myDepthRange.x, 0.0);
  if (!crosses)
  {
    for (int i = 0; i < 3; ++i)
    {
      u[i] = rtwWarp(rtwLayer, focusedPoint[i].xy / focusedPoint[i].w);
    }
    if (max(bend.x, bend.y) <= rtwAllowedBend)
    {
      for (int i = 0; i < 3; ++i)
      {
        rtwEmit(u[i], nearest);
      }
      return;
    }
  }
  myBent = 1;
  bend += MARGIN * texel;
  vec2 low = max(rtwWarp(rtwLayer, bounds.xy) - MARGIN * texel, vec2(0.0));
  vec2 high = min(rtwWarp(rtwLayer, bounds.zw) + MARGIN * texel, vec2(1.0));
  if (any(greaterThan(low, high)))
  {
    return;
  }
  vec2 size = high - low;
  if (!crosses)
  {
    vec2 a = u[1] - u[0];
    vec2 b = u[2] - u[1];
    vec2 c = u[0] - u[2];
    vec2 along = dot(a, a) > dot(b, b) ? a : b;
    along = dot(c, c) > dot(along, along) ? c : along;
    along /= max(length(along), 1e-20);
    vec2 across = vec2(-along.y, along.x);
    vec3 x = vec3(dot(u[0], along), dot(u[1], along), dot(u[2], along));
    vec3 y = vec3(dot(u[0], across), dot(u[1], across), dot(u[2], across));
    float growX = dot(abs(along), bend);
    float growY = dot(abs(across), bend);
    vec2 from = vec2(min(x.x, min(x.y, x.z)) - growX, min(y.x, min(y.y, y.z)) - growY);
    vec2 to = vec2(max(x.x, max(x.y, x.z)) + growX, max(y.x, max(y.y, y.z)) + growY);
    vec2 grown[3] = u;
    rtwGrow(grown, bend);
    float grownArea = rtwArea(grown);
    float boxArea = (to.x - from.x) * (to.y - from.y);
    if (grownArea < min(boxArea, size.x * size.y))
    {
      for (int i = 0; i < 3; ++i)
      {
        rtwEmit(grown[i], nearest);
      }
      return;
    }
    if (boxArea < size.x * size.y)
    {
      rtwEmit(from.x * along + from.y * across, nearest);
      rtwEmit(to.x * along + from.y * across, nearest);
      rtwEmit(from.x * along + to.y * across, nearest);
      rtwEmit(to.x * along + to.y * across, nearest);
      return;
    }
  }
  rtwEmit(low, nearest);
  rtwEmit(vec2(high.x, low.y), nearest);
  rtwEmit(vec2(low.x, high.y), nearest);
  rtwEmit(high, nearest);
}
