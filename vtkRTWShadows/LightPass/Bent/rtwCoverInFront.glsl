// Covers of a triangle under a warp that keeps straight lines straight: itself, as far as it is in front of the spot and of the warp's centre of
// projection. Each fragment takes its depth from the triangle's plane.
const int MOST_CORNERS = 5; // three, and one more for each of two cuts

// What is left of a polygon in homogeneous light-plane coordinates where its product with the plane is positive. An edge is cut in the
// direction that leads out, so that it is cut alike in both of its triangles.
void rtwCut(inout vec3 corners[MOST_CORNERS], inout int count, vec4 plane)
{
  vec3 kept[MOST_CORNERS];
  int left = 0;
  for (int i = 0; i < count; ++i)
  {
    vec3 here = corners[i];
    vec3 next = corners[(i + 1) % count];
    float a = dot(plane, vec4(here, 1.0));
    float b = dot(plane, vec4(next, 1.0));
    if (a >= 0.0 && left < MOST_CORNERS)
    {
      kept[left++] = here;
    }
    if ((a >= 0.0) != (b >= 0.0) && left < MOST_CORNERS)
    {
      kept[left++] = a >= 0.0 ? mix(here, next, a / (a - b)) : mix(next, here, b / (b - a));
    }
  }
  corners = kept;
  count = left;
}

void rtwCover(Caster t, uint place, uint caster, vec2 u[3], vec2 bend)
{
  vec3 corners[MOST_CORNERS];
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = t.points[k].xyw;
  }
  int count = 3;
  rtwCut(corners, count, vec4(0.0, 0.0, 1.0, -rtwNearestW));
  rtwCut(corners, count, vec4(rtwFront(rtwLayer), 0.0));
  vec2 onMap[MOST_CORNERS];
  for (int k = 0; k < count; ++k)
  {
    onMap[k] = rtwWarp(rtwLayer, corners[k].xy / corners[k].z);
  }
  for (int k = 2; k < count; ++k)
  {
    rtwAddCover(2u * caster, onMap[0], onMap[k - 1], onMap[k], max(t.depths.x, 0.0));
  }
}
