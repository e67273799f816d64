// Which clusters can cast a shadow into a layer that is seen, and how many triangles at the start of each, the largest, the warp may bend.
layout(local_size_x = 64) in;
layout(std430, binding = 3) writeonly buffer BentEnds
{
  // For each draw: 0 if it is culled, otherwise one more than the end of its indices that the warp may bend.
  uint rtwBentEnds[];
};
layout(std430, binding = 5) buffer Counts
{
  uint rtwCounts[]; // for each layer: clusters drawn, clusters culled
};
uniform int rtwNumberOfDraws;
uniform int rtwLayer;
uniform int rtwCull;           // whether to leave out what shadows nothing in view
uniform int rtwBending;        // whether bent triangles are treated apart
uniform float rtwNearestW;     // what is nearer to a spot casts no shadow
uniform float rtwLeastBend;    // the share of the map's side below which bends don't matter

struct Extent
{
  vec2 low;
  vec2 high;
  float nearest; // depth
  float leastW;
  float mostW;
};

Extent rtwExtentOf(Cluster cluster, mat4 m)
{
  Extent e = Extent(vec2(1e30), vec2(-1e30), 1e30, 1e30, -1e30);
  for (int i = 0; i < 8; ++i)
  {
    vec4 p = m * vec4(rtwCorner(cluster, i), 1.0);
    vec3 q = p.xyz / p.w;
    e.low = min(e.low, q.xy);
    e.high = max(e.high, q.xy);
    e.nearest = min(e.nearest, q.z);
    e.leastW = min(e.leastW, p.w);
    e.mostW = max(e.mostW, p.w);
  }
  return e;
}

vec3 rtwRow(mat4 m, int row)
{
  return abs(vec3(m[0][row], m[1][row], m[2][row]));
}

// How large a triangle of that extent in the mesh can be on the light plane.
vec2 rtwLargestOnLight(mat4 m, Extent e, float extent)
{
  vec3 w = rtwRow(m, 3);
  vec2 farthest = max(abs(e.low), abs(e.high));
  return extent * vec2(dot(rtwRow(m, 0), vec3(1.0)) + farthest.x * dot(w, vec3(1.0)),
    dot(rtwRow(m, 1), vec3(1.0)) + farthest.y * dot(w, vec3(1.0))) / e.leastW;
}

uint rtwBentIndices(Cluster cluster, mat4 m, Extent e)
{
  uint end = 0u;
  float extent = cluster.largestExtent;
  for (int k = 0; k < SIZE_CLASSES; ++k)
  {
    vec2 piece = min(rtwLargestOnLight(m, e, extent), e.high - e.low);
    vec2 bends = rtwBendsOfPieces(rtwLayer, e.low, e.high, piece);
    if (max(bends.x, bends.y) <= rtwLeastBend)
    {
      break;
    }
    end = cluster.classEnd[k];
    extent *= 0.5;
  }
  return end;
}

bool rtwCanShadow(Extent e)
{
  if (e.leastW < rtwNearestW) // it reaches behind the light, where its corners tell nothing
  {
    return e.mostW >= rtwNearestW;
  }
  vec4 bounds = rtwBoundsOnMap(rtwLayer, e.low, e.high) * float(rtwWarpSize.y);
  return all(lessThanEqual(e.low, vec2(1.0))) && all(greaterThanEqual(e.high, vec2(0.0))) && e.nearest <= 1.0 &&
    !rtwIsBehindAll(ivec4(bounds), e.nearest);
}

void main()
{
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rtwNumberOfDraws)
  {
    return;
  }
  ClusterDraw draw = rtwDraws[i];
  Cluster cluster = rtwClusters[draw.cluster];
  mat4 m = rtwMatrices[draw.instance];
  Extent e = rtwExtentOf(cluster, m);
  bool crosses = e.leastW < rtwNearestW;
  bool casts = (draw.flags & CASTS) != 0u && (rtwCanShadow(e) || rtwCull == 0);
  uint end = cluster.classEnd[SIZE_CLASSES - 1];
  uint bent = crosses ? end : rtwBending == 0 ? 0u : rtwBentIndices(cluster, m, e);
  rtwBentEnds[i] = casts ? bent + 1u : 0u;
  if ((draw.flags & CASTS) != 0u)
  {
    atomicAdd(rtwCounts[2 * rtwLayer + (casts ? 0 : 1)], 1u);
  }
}
