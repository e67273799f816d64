// Patches of tessellated triangles, in classes of 1, 2, 4 … pieces along an edge at most, and where each class lies.
uint rtwPatchVertices(uint kind)
{
  return 3u << (2u * kind);
}

// Patches of a cluster in a class, at most: a triangle has one patch, or several of the last class.
uint rtwPatchesOf(uint kind)
{
  return kind < PATCH_CLASSES - 1u ? MOST_TRIANGLES : MOST_COVERS;
}

uint rtwPatchPlace(uint kind)
{
  return MOST_CLUSTERS * (MOST_COVERS + kind * MOST_TRIANGLES);
}
