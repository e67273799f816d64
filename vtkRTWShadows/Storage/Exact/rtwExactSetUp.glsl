// The triangles of a cluster that may shadow any sample, and where the search for those samples starts. In double precision, because the
// origin of the light plane is the view's, not the mesh's.
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Points
{
  float rtwPoints[];
};
layout(std430, binding = 1) readonly buffer Indices
{
  uint rtwIndices[];
};
layout(std430, binding = 2) readonly buffer MeshMatrices
{
  dmat4 rtwMeshToPlane[]; // for each instance
};
layout(std430, binding = 4) readonly buffer Kept
{
  uvec4 rtwKept[];
};
uniform float rtwNearestW;
uniform int rtwCasterCapacity;

const uint CASTERS = 72u; // place of the number of casters in the queue

dvec4 rtwCornerAt(uvec4 cluster, uint index)
{
  uint i = 3u * (cluster.z + rtwIndices[cluster.x + index]);
  return rtwMeshToPlane[cluster.w] * dvec4(rtwPoints[i], rtwPoints[i + 1u], rtwPoints[i + 2u], 1.0);
}

// The slope of depth, or one too steep to tell anything where the triangle is so thin that rounding decides it.
vec2 rtwSlopeOf(vec3 a, vec3 b, vec3 c)
{
  vec3 ab = b - a;
  vec3 ac = c - a;
  vec2 slope = vec2(ab.z * ac.y - ab.y * ac.z, ab.x * ac.z - ab.z * ac.x) / (ab.x * ac.y - ab.y * ac.x);
  vec2 extent = max(abs(ab.xy), abs(ac.xy));
  float range = max(max(ab.z, ac.z), 0.0) - min(min(ab.z, ac.z), 0.0);
  return dot(abs(slope), extent) <= 16.0 * range ? slope : vec2(STEEP);
}

void rtwAddCaster(dvec4 ha, dvec4 hb, dvec4 hc)
{
  vec3 a = vec3(ha.xyz / ha.w);
  vec3 b = vec3(hb.xyz / hb.w);
  vec3 c = vec3(hc.xyz / hc.w);
  vec2 slope = rtwSlopeOf(a, b, c);
  ExactCaster t = ExactCaster(vec4(a, slope.x), vec4(b, slope.y), vec4(c, min(min(a.z, b.z), c.z)));
  GridStart start = rtwStartOf(min(min(a.xy, b.xy), c.xy), max(max(a.xy, b.xy), c.xy));
  uint caster = 0xffffffffu;
  for (uint y = start.first.y; y <= start.last.y; ++y)
  {
    for (uint x = start.first.x; x <= start.last.x; ++x)
    {
      uint node = rtwStartNode(start, x, y);
      if (rtwNodes[node].count == 0u || !rtwMeets(t, rtwNodes[node]))
      {
        continue;
      }
      if (caster == 0xffffffffu)
      {
        caster = atomicAdd(rtwQueue[CASTERS], 1u);
        if (caster >= uint(rtwCasterCapacity))
        {
          rtwQueue[OVERFLOW] = 1u;
          return;
        }
        rtwExactCasters[caster] = t;
      }
      rtwPushNode(0u, caster, node, uint(start.level));
    }
  }
}

// The point at which an edge from before a lamp to beside or behind it leaves what can cast a shadow.
dvec4 rtwCut(dvec4 front, dvec4 behind)
{
  dvec4 cut = mix(front, behind, (double(rtwNearestW) - front.w) / (behind.w - front.w));
  cut.w = double(rtwNearestW);
  return cut;
}

// Adds the part of a triangle that isn't beside or behind a lamp: a triangle where two corners are behind, two
// triangles where one is. No array is indexed by what is computed: some drivers lose elements of those.
void rtwAddClipped(dvec4 a, dvec4 b, dvec4 c)
{
  bvec3 front = bvec3(a.w >= rtwNearestW, b.w >= rtwNearestW, c.w >= rtwNearestW);
  int count = int(front.x) + int(front.y) + int(front.z);
  if (count == 0)
  {
    return;
  }
  // The corner that differs from the other two comes first.
  bool odd = count == 1;
  bool second = front.y == odd && front.x != odd;
  bool third = front.z == odd && front.x != odd && front.y != odd;
  dvec4 p = second ? b : third ? c : a;
  dvec4 q = second ? c : third ? a : b;
  dvec4 r = second ? a : third ? b : c;
  dvec4 pq = odd ? rtwCut(p, q) : rtwCut(q, p);
  dvec4 pr = odd ? rtwCut(p, r) : rtwCut(r, p);
  for (int part = 0; part < (odd ? 1 : 2); ++part)
  {
    rtwAddCaster(odd ? p : part == 0 ? q : pr, odd ? pq : part == 0 ? r : pq, odd ? pr : part == 0 ? pr : q);
  }
}

void main()
{
  uvec4 cluster = rtwKept[gl_WorkGroupID.x];
  for (uint i = 3u * gl_LocalInvocationID.x; i < cluster.y; i += 3u * gl_WorkGroupSize.x)
  {
    dvec4 h[3] = dvec4[3](rtwCornerAt(cluster, i), rtwCornerAt(cluster, i + 1u), rtwCornerAt(cluster, i + 2u));
    if (min(min(h[0].w, h[1].w), h[2].w) >= rtwNearestW)
    {
      rtwAddCaster(h[0], h[1], h[2]);
    }
    else
    {
      rtwAddClipped(h[0], h[1], h[2]);
    }
  }
}
