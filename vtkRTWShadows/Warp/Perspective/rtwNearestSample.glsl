// The nearest view sample that the light reaches: the paper's n.
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) buffer Nearest
{
  uint rtwNearestOf[]; // a layer: one over its distance along the view; the bits of a positive float, which are in its order
};
uniform int rtwLayer;
shared uint rtwNearestOfTile;
float rtwMine = 0.0;

void rtwVisit(LitSample s)
{
  rtwMine = max(rtwMine, 1.0 / rtwDistance(s.position));
}

void main()
{
  if (gl_LocalInvocationIndex == 0u)
  {
    rtwNearestOfTile = 0u;
  }
  barrier();
  rtwVisitTile();
  atomicMax(rtwNearestOfTile, floatBitsToUint(rtwMine));
  barrier();
  if (gl_LocalInvocationIndex == 0u && rtwNearestOfTile != 0u)
  {
    atomicMax(rtwNearestOf[rtwLayer], rtwNearestOfTile);
  }
}
