// Which clusters the camera can see: those whose bounds aren't wholly behind one side of its frustum.
layout(local_size_x = 64) in;
layout(std430, binding = 3) writeonly buffer Commands
{
  DrawCommand rtwCommands[];
};
uniform int rtwNumberOfDraws;
uniform int rtwWanted; // flags

bool rtwVisible(Cluster cluster, mat4 toClip)
{
  uint outside = 63u;
  for (int i = 0; i < 8; ++i)
  {
    vec4 p = toClip * vec4(rtwCorner(cluster, i), 1.0);
    outside &= (p.x < -p.w ? 1u : 0u) | (p.x > p.w ? 2u : 0u) | (p.y < -p.w ? 4u : 0u) |
      (p.y > p.w ? 8u : 0u) | (p.z < -p.w ? 16u : 0u) | (p.z > p.w ? 32u : 0u);
  }
  return outside == 0u;
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
  bool seen = (draw.flags & uint(rtwWanted)) != 0u && rtwVisible(cluster, rtwMatrices[draw.instance]);
  rtwCommands[i] = rtwCommand(cluster, 0u, seen ? cluster.classEnd[SIZE_CLASSES - 1] : 0u, draw.instance);
}
