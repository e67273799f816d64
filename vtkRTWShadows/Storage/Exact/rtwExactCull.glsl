// Which clusters of triangles may shadow any sample.
layout(local_size_x = 64) in;
layout(std430, binding = 4) writeonly buffer Kept
{
  uvec4 rtwKept[]; // for each kept cluster: first index, number of indices, base vertex, instance
};
layout(std430, binding = 5) buffer Counts
{
  uint rtwCounts[]; // for each layer: clusters drawn, clusters culled
};
uniform int rtwFirstDraw;
uniform int rtwEndDraw;
uniform int rtwCull;
uniform float rtwNearestW; // what is nearer to a spot casts no shadow
uniform float rtwRounding; // a length in world units
uniform float rtwReference; // r of rtwCountSamples.glsl

bool rtwReaches(Cluster cluster, mat4 m)
{
  vec2 low = vec2(1e30);
  vec2 high = vec2(-1e30);
  float nearest = 1e30;
  float leastW = 1e30;
  float mostW = -1e30;
  for (int i = 0; i < 8; ++i)
  {
    vec4 p = m * vec4(rtwCorner(cluster, i), 1.0);
    vec3 l = p.xyz / p.w;
    low = min(low, l.xy);
    high = max(high, l.xy);
    nearest = min(nearest, l.z);
    leastW = min(leastW, p.w);
    mostW = max(mostW, p.w);
  }
  if (mostW < rtwNearestW || leastW < rtwNearestW)
  {
    return mostW >= rtwNearestW;
  }
  float margin = rtwRounding / leastW;
  low -= margin;
  high += margin;
  nearest -= rtwReference > 0.0 ? margin / leastW * rtwReference * rtwReference : margin;
  GridStart start = rtwStartOf(low, high);
  for (uint y = start.first.y; y <= start.last.y; ++y)
  {
    for (uint x = start.first.x; x <= start.last.x; ++x)
    {
      GridNode node = rtwNodes[rtwStartNode(start, x, y)];
      if (all(lessThanEqual(low, node.high)) && all(greaterThanEqual(high, node.low)) && nearest < node.deepest)
      {
        return true;
      }
    }
  }
  return false;
}

void main()
{
  int i = rtwFirstDraw + int(gl_GlobalInvocationID.x);
  if (i >= rtwEndDraw || (rtwDraws[i].flags & CASTS) == 0u)
  {
    return;
  }
  ClusterDraw draw = rtwDraws[i];
  Cluster cluster = rtwClusters[draw.cluster];
  bool casts = rtwCull == 0 || rtwReaches(cluster, rtwMatrices[draw.instance]);
  atomicAdd(rtwCounts[2 * rtwLayer + (casts ? 0 : 1)], 1u);
  if (casts)
  {
    uint place = atomicAdd(rtwQueue[4u * CLUSTERS], 1u);
    rtwKept[place] = uvec4(cluster.firstIndex, cluster.classEnd[SIZE_CLASSES - 1], cluster.baseVertex, draw.instance);
  }
}
