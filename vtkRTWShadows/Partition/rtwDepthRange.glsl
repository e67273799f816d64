// The nearest and the farthest distance along the view direction at which the light reaches what the camera sees, by parallel reduction.
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) buffer Range
{
  uint rtwRange[]; // a light: nearest, farthest, as the bits of floats, which are ordered as they are
};
uniform int rtwLight;
shared uint rtwNearestBits;
shared uint rtwFarthestBits;
float rtwNearestSeen = 1e30; // by this invocation
float rtwFarthestSeen = 0.0;

void rtwVisit(LitSample s)
{
  rtwNearestSeen = min(rtwNearestSeen, max(-s.position.z, 0.0));
  rtwFarthestSeen = max(rtwFarthestSeen, -s.position.z);
}

void main()
{
  if (gl_LocalInvocationIndex == 0u)
  {
    rtwNearestBits = floatBitsToUint(1e30);
    rtwFarthestBits = 0u;
  }
  barrier();
  rtwVisitTile();
  atomicMin(rtwNearestBits, floatBitsToUint(rtwNearestSeen));
  atomicMax(rtwFarthestBits, floatBitsToUint(rtwFarthestSeen));
  barrier();
  if (gl_LocalInvocationIndex == 0u && rtwFarthestBits != 0u)
  {
    atomicMin(rtwRange[2 * rtwLight], rtwNearestBits);
    atomicMax(rtwRange[2 * rtwLight + 1], rtwFarthestBits);
  }
}
