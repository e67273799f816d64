// View samples that a light reaches, as they lie on its plane, for a comparison of turns of that plane: a few of many, and apart from
// them, since they are rare, the pixels at shadow edges.
layout(local_size_x = 16, local_size_y = 16) in;

layout(std430, binding = 0) buffer Samples
{
  uint rtwCount;
  uint rtwEdgeCount;
  vec4 rtwListed[]; // samples: place and step to the right; step above; then edges: likewise, and their normal; their number, where they lie in view coordinates
};
uniform sampler2DArray rtwMask; // the shadow mask of the frame that the samples are of
uniform int rtwHasMask;
uniform int rtwLight;
uniform int rtwStep;  // every how many samples, along both axes, one is taken
uniform int rtwFineStep; // every how many are looked at for edges
uniform int rtwSlots; // in either list

struct Listed
{
  bool used;
  vec2 place, dx, dy;
  vec3 position;
};

// The sample of a pixel. Like in an analysis, what faces both viewer and light is seen the other way round by the
// light.
Listed rtwList(ivec2 pixel)
{
  SampledPlane plane = rtwLoadPlane(pixel);
  vec3 here = rtwOnLight(plane.here);
  Listed s;
  s.place = here.xy;
  s.position = plane.here;
  s.dx = rtwOnLight(plane.right).xy - here.xy;
  s.dy = rtwOnLight(plane.above).xy - here.xy;
  s.used = plane.seen && s.dx.x * s.dy.y - s.dx.y * s.dy.x < 0.0 && here.z > 0.0 && rtwReached(here.xy);
  return s;
}

void rtwAddEdge(Listed s, vec2 normal, uint number)
{
  uint slot = s.used ? atomicAdd(rtwEdgeCount, 1u) : uint(rtwSlots);
  if (slot < uint(rtwSlots))
  {
    uint place = 2u * uint(rtwSlots) + 3u * slot;
    rtwListed[place] = vec4(s.place, s.dx);
    rtwListed[place + 1u] = vec4(s.dy, normal);
    rtwListed[place + 2u] = vec4(float(number), s.position);
  }
}

// Lists one of a cell's edges, chosen at random, which stands for all of them.
void rtwFindEdge(ivec2 corner)
{
  ivec2 end = min(corner + rtwStep, textureSize(rtwSamples, 0));
  uint found = 0u;
  uint chance = uint(corner.x) * 1664525u + uint(corner.y) * 1013904223u + 1u;
  ivec2 edge = corner;
  for (int y = corner.y; y < end.y; y += rtwFineStep)
  {
    for (int x = corner.x; x < end.x; x += rtwFineStep)
    {
      if (rtwBesideEdge(rtwMask, rtwLight, ivec2(x, y)))
      {
        ++found;
        chance = chance * 1664525u + 1013904223u;
        edge = (chance >> 8) % found == 0u ? ivec2(x, y) : edge;
      }
    }
  }
  if (found > 0u)
  {
    rtwAddEdge(rtwList(edge), rtwEdgeNormal(rtwMask, rtwLight, edge), found);
  }
}

void main()
{
  ivec2 corner = ivec2(gl_GlobalInvocationID.xy) * rtwStep;
  ivec2 pixel = corner + rtwStep / 2;
  if (any(greaterThanEqual(pixel, textureSize(rtwSamples, 0))))
  {
    return;
  }
  Listed s = rtwList(pixel);
  uint slot = s.used ? atomicAdd(rtwCount, 1u) : uint(rtwSlots);
  if (slot < uint(rtwSlots))
  {
    rtwListed[2u * slot] = vec4(s.place, s.dx);
    rtwListed[2u * slot + 1u] = vec4(s.dy, 0.0, 0.0);
  }
  if (rtwHasMask != 0)
  {
    rtwFindEdge(corner);
  }
  else
  {
    rtwAddEdge(s, vec2(0.0), 1u); // without a mask all samples count as being at an edge
  }
}
