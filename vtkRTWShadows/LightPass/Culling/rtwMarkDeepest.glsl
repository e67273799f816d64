// Writes into the least squares of texels that a view sample looks up how deep it lies.
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 0) buffer Deepest
{
  uint rtwDeepest[]; // as bits, whose order is that of the depths; 0 where there is no sample
};
uniform int rtwLayer;
uniform float rtwReach; // how far a lookup reaches, in texels: no more than half of a square

const float ROUNDING = 1e-6; // of depth
const int PIXELS = 4;         // a side of a square that an invocation looks at

void rtwMark(ivec2 at, uint depth)
{
  int square = rtwDeepestPlace(rtwWarpSize.y, 0, at);
  if (rtwDeepest[square] < depth)
  {
    atomicMax(rtwDeepest[square], depth);
  }
}

void rtwMarkFrom(MovingSample s, vec4 focus)
{
  uint depth = floatBitsToUint(clamp(s.h.z / s.h.w, 0.0, 1.0) + ROUNDING);
  vec2 place = rtwWarp(rtwLayer, rtwFocused(focus, s.h.xy / s.h.w)) * float(rtwWarpSize.y);
  float last = float(rtwWarpSize.y - 1);
  ivec2 first = ivec2(clamp(place - rtwReach, 0.0, last)) >> rtwSquare;
  ivec2 end = ivec2(clamp(place + rtwReach, 0.0, last)) >> rtwSquare;
  rtwMark(first, depth);
  if (first.x != end.x)
  {
    rtwMark(ivec2(end.x, first.y), depth);
  }
  if (first.y != end.y)
  {
    rtwMark(ivec2(first.x, end.y), depth);
    rtwMark(end, depth);
  }
}

void main()
{
  vec4 focus = rtwFocus(rtwLayer);
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * 16 * PIXELS + ivec2(gl_LocalInvocationID.xy);
  for (int i = 0; i < PIXELS * PIXELS; ++i)
  {
    ivec2 pixel = corner + 16 * ivec2(i % PIXELS, i / PIXELS);
    if (all(lessThan(pixel, textureSize(rtwSamples, 0))))
    {
      MovingSample s = rtwLoadMovingSample(pixel);
      if (s.lit)
      {
        rtwMarkFrom(s, focus);
      }
    }
  }
}
