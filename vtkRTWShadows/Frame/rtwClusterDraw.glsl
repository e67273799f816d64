// Clusters of triangles and the places where they stand, as the geometry store uploads them, and how to draw them.
const int SIZE_CLASSES = 8;
const uint CASTS = 1u;

struct Cluster
{
  vec3 low;
  float largestExtent;
  vec3 high;
  uint firstIndex;
  uint baseVertex;
  uint unused[3];
  uint classEnd[SIZE_CLASSES];
};

struct ClusterDraw
{
  uint cluster;
  uint instance;
  uint flags;
  uint unused;
};

struct DrawCommand
{
  uint count;
  uint instanceCount;
  uint firstIndex;
  uint baseVertex;
  uint baseInstance;
};

layout(std430, binding = 0) readonly buffer Clusters
{
  Cluster rtwClusters[];
};
layout(std430, binding = 1) readonly buffer Draws
{
  ClusterDraw rtwDraws[];
};
layout(std430, binding = 2) readonly buffer Matrices
{
  mat4 rtwMatrices[]; // for each instance
};

DrawCommand rtwCommand(Cluster cluster, uint first, uint end, uint instance)
{
  return DrawCommand(end - first, 1u, cluster.firstIndex + first, cluster.baseVertex, instance);
}

vec3 rtwCorner(Cluster cluster, int i)
{
  return vec3((i & 1) != 0 ? cluster.high.x : cluster.low.x, (i & 2) != 0 ? cluster.high.y : cluster.low.y,
    (i & 4) != 0 ? cluster.high.z : cluster.low.z);
}
