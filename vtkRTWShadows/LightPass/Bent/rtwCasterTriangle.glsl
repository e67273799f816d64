// A triangle of a cluster as the light sees it, and which texels' centres it can hide.
layout(std430, binding = 0) readonly buffer Points
{
  float rtwPoints[];
};
layout(std430, binding = 1) readonly buffer Indices
{
  uint rtwIndices[];
};
layout(std430, binding = 2) readonly buffer Matrices
{
  mat4 rtwMatrices[]; // for each instance: from the mesh to (q · w, depth · w, w)
};
uniform int rtwLayer;
uniform float rtwNearestW; // what is nearer to a spot casts no shadow

const float MARGIN = 0.02; // a share of a texel, for rounding

struct Caster
{
  vec4 points[3];
  vec2 depths; // least and greatest
  vec2 low;    // bounds of q
  vec2 high;
  bool crosses; // whether it crosses the plane of a spot
};

// The edges and the plane of a triangle, in light-plane coordinates.
struct CasterPlane
{
  vec3 edges[3];
  vec3 anchor;
  vec2 slope;
};

vec4 rtwPoint(uint corner)
{
  uint i = 3u * (rtwWork[gl_WorkGroupID.x].baseVertex + rtwIndices[rtwWork[gl_WorkGroupID.x].firstIndex + corner]);
  return rtwMatrices[rtwWork[gl_WorkGroupID.x].instance] * vec4(rtwPoints[i], rtwPoints[i + 1u], rtwPoints[i + 2u], 1.0);
}

void rtwExtend(inout Caster t, vec3 p)
{
  t.low = min(t.low, p.xy);
  t.high = max(t.high, p.xy);
  t.depths = vec2(min(t.depths.x, p.z), max(t.depths.y, p.z));
}

// Sets the bounds of the part that is not behind the light. False where no part is left or all of it lies beside the
// map.
bool rtwSetBounds(inout Caster t)
{
  t.low = vec2(1e30);
  t.high = vec2(-1e30);
  t.depths = vec2(1e30, -1e30);
  t.crosses = false;
  for (int i = 0; i < 3; ++i)
  {
    vec4 a = t.points[i];
    vec4 b = t.points[(i + 1) % 3];
    if (a.w >= rtwNearestW)
    {
      rtwExtend(t, a.xyz / a.w);
    }
    if ((a.w < rtwNearestW) != (b.w < rtwNearestW))
    {
      rtwExtend(t, mix(a, b, (rtwNearestW - a.w) / (b.w - a.w)).xyz / rtwNearestW);
      t.crosses = true;
    }
  }
  return all(lessThanEqual(t.low, t.high)) && all(lessThanEqual(t.low, vec2(1.0))) && all(greaterThanEqual(t.high, vec2(0.0))) &&
    t.depths.x <= 1.0;
}

// The first and last texel along each axis whose centre lies in bounds on the map.
ivec4 rtwTexels(vec4 bounds)
{
  vec2 size = vec2(rtwMapSize);
  vec2 first = ceil(clamp(bounds.xy, 0.0, 1.0) * size - 0.5 - MARGIN);
  vec2 last = floor(clamp(bounds.zw, 0.0, 1.0) * size - 0.5 + MARGIN);
  return ivec4(max(first, 0.0), min(last, size - 1.0));
}

// The texels whose centres the triangle can hide.
ivec4 rtwTexelsOf(Caster t)
{
#if defined(RTW_TRIANGLES_ON_MAP)
  if (!t.crosses)
  {
    return rtwTexels(rtwTriangleOnMap(rtwLayer, t.low, t.high,
      vec2[3](t.points[0].xy / t.points[0].w, t.points[1].xy / t.points[1].w, t.points[2].xy / t.points[2].w)));
  }
#endif
  return rtwTexels(rtwBoundsOnMap(rtwLayer, t.low, t.high));
}

// Loads a triangle of the cluster; false where it hides nothing.
bool rtwLoadCaster(uint triangle, out Caster t)
{
  for (int k = 0; k < 3; ++k)
  {
    t.points[k] = rtwPoint(3u * triangle + uint(k));
  }
  return rtwSetBounds(t);
}
