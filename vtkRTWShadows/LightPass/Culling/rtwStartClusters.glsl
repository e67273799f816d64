// The next of a layer's listed clusters, made ready for their triangles to be culled and set up. Places beyond the list's end draw nothing.
layout(local_size_x = 64) in;
layout(std430, binding = 4) readonly buffer List
{
  uint rtwListed[2];
  uvec2 rtwList[];
};
layout(std430, binding = 5) writeonly buffer WorkGroups
{
  uint rtwWorkGroups[3]; // one for each cluster
};
uniform int rtwFirst; // the first place of the list at work
uniform int rtwMost;  // clusters at a time

void main()
{
  uint i = gl_GlobalInvocationID.x;
  uint left = max(rtwListed[0], uint(rtwFirst)) - uint(rtwFirst);
  if (i == 0u)
  {
    rtwWorkGroups = uint[3](min(left, uint(rtwMost)), 1u, 1u);
  }
  if (i >= uint(rtwMost))
  {
    return;
  }
  rtwWork[i].straightDraw = uint[4](0u, 1u, 3u * MOST_TRIANGLES * i, 0u);
  rtwWork[i].bentDraw = uint[4](0u, 1u, 6u * MOST_COVERS * i, 0u);
  rtwWork[i].planeDraw = uint[4](0u, 1u, 3u * MOST_TRIANGLES * i, 0u);
  for (uint k = 0u; k < PATCH_CLASSES; ++k)
  {
    rtwWork[i].patchDraw[4u * k] = 0u;
    rtwWork[i].patchDraw[4u * k + 1u] = 1u;
    rtwWork[i].patchDraw[4u * k + 2u] = rtwPatchVertices(k) * rtwPatchesOf(k) * i;
    rtwWork[i].patchDraw[4u * k + 3u] = 0u;
  }
  rtwWork[i].slices = 0u;
  rtwWork[i].patches = 0u;
  rtwWork[i].numberOfCasters = 0u;
  rtwWork[i].end = 0u;
  if (i < left)
  {
    uvec2 listed = rtwList[uint(rtwFirst) + i];
    ClusterDraw draw = rtwDraws[listed.x];
    Cluster cluster = rtwClusters[draw.cluster];
    rtwWork[i].firstIndex = cluster.firstIndex;
    rtwWork[i].baseVertex = cluster.baseVertex;
    rtwWork[i].instance = draw.instance;
    rtwWork[i].bentEnd = listed.y;
    rtwWork[i].end = cluster.classEnd[SIZE_CLASSES - 1];
  }
}
