// A piece of a patch of a tessellated triangle: each corner is warped by itself.
//
// Depth is that of the triangle's plane at each texel; interpolated, it would be too far off for a depth test without a bias.
//
// On an edge of the triangle the corners are those that the edge has for itself, so that the triangle beyond it, which may be tessellated
// more finely or less, meets it there.
layout(std430, binding = 5) readonly buffer BentCasters
{
  BentCaster rtwBent[];
};
layout(std430, binding = 6) readonly buffer Covers
{
  CasterCover rtwCovers[];
};
uniform int rtwLayer;
uniform int rtwPatchClass; // the class of patches that the draw call is for
flat out vec3 anchor;
flat out vec2 slope;
flat out vec2 depthRange;

// The corner of a piece, in pieces from the patch's first corner. Row y has 2 (side - y) - 1 pieces, every second upside down.
vec2 rtwCorner(int piece, int corner, int side)
{
  int y = 0;
  while (piece >= 2 * (side - y) - 1)
  {
    piece -= 2 * (side - y) - 1;
    ++y;
  }
  vec2 at = vec2(float(piece / 2), float(y));
  bool down = piece % 2 == 1;
  vec2 one = down ? vec2(1.0) : vec2(0.0);
  vec2 two = down ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  vec2 three = down ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  return at + (corner == 0 ? one : corner == 1 ? two : three);
}

vec2 rtwOnMap(vec4 point)
{
  return rtwWarp(rtwLayer, point.xy / point.w);
}

// The point at `t` on the way from a to b along so many straight pieces; the same points result from b to a.
vec2 rtwOnEdge(vec4 a, vec4 b, float t, float pieces)
{
  if (a.x > b.x || (a.x == b.x && (a.y > b.y || (a.y == b.y && a.z > b.z))))
  {
    vec4 swap = a;
    a = b;
    b = swap;
    t = 1.0 - t;
  }
  float at = t * pieces;
  float first = min(floor(at + 1e-3), pieces - 1.0);
  float f = at - first;
  vec2 low = rtwOnMap(mix(a, b, first / pieces));
  return f < 2e-3 ? low : mix(low, rtwOnMap(mix(a, b, (first + 1.0) / pieces)), f);
}

vec2 rtwTessellated(BentCaster caster, vec2 at)
{
  vec2 counts = floor(caster.anchor.zw / PIECES);
  vec2 others = caster.anchor.zw - PIECES * counts;
  float pieces = counts.x;
  vec4 a = caster.edges[0];
  vec4 b = caster.edges[1];
  vec4 c = caster.edges[2];
  vec2 onMap = rtwOnMap(a + (b - a) * (at.x / pieces) + (c - a) * (at.y / pieces));
  onMap = at.y == 0.0 ? rtwOnEdge(a, b, at.x / pieces, others.x) : onMap;
  onMap = at.x + at.y == pieces ? rtwOnEdge(b, c, at.y / pieces, counts.y) : onMap;
  return at.x == 0.0 ? rtwOnEdge(c, a, 1.0 - at.y / pieces, others.y) : onMap;
}

// Where in its triangle, in pieces, a vertex of a patch lies.
vec2 rtwAt(CasterCover patch_, int k, int side)
{
  vec2 local = rtwCorner(k / 3, k % 3, side) / float(side);
  vec2 at = patch_.corners[0] + local.x * (patch_.corners[1] - patch_.corners[0]) + local.y * (patch_.corners[2] - patch_.corners[0]);
  return floor(at + 0.5);
}

void main()
{
  uint kind = uint(rtwPatchClass);
  uint i = uint(gl_VertexID) / rtwPatchVertices(kind);
  int k = gl_VertexID - int(rtwPatchVertices(kind) * i);
  CasterCover part = rtwCovers[rtwPatchPlace(kind) + i];
  int side = int(part.depth);
  gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // a piece too many has no area
  anchor = vec3(0.0);
  slope = vec2(0.0);
  depthRange = vec2(0.0);
  if (k / 3 < side * side)
  {
    BentCaster caster = rtwBent[part.caster];
    vec2 onMap = side == 1 ? part.corners[k] : rtwTessellated(caster, rtwAt(part, k, side));
    slope = caster.anchor.xy;
    vec3 a = caster.edges[0].xyz / caster.edges[0].w;
    float b = caster.edges[1].z / caster.edges[1].w;
    float c = caster.edges[2].z / caster.edges[2].w;
    anchor = a;
    depthRange = vec2(min(a.z, min(b, c)), max(a.z, max(b, c)));
    gl_Position = vec4(2.0 * onMap - 1.0, 0.0, 1.0); // depth is the fragments' to say
  }
}
