// The deepest of each four squares, for the next level.
layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) buffer Deepest
{
  uint rtwDeepest[];
};
uniform int rtwTexels; // texels a side of the map
uniform int rtwLevel;

void main()
{
  ivec2 square = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(square, ivec2(rtwDeepestSide(rtwTexels) >> rtwLevel))))
  {
    uint deepest = 0u;
    for (int k = 0; k < 4; ++k)
    {
      deepest = max(deepest, rtwDeepest[rtwDeepestPlace(rtwTexels, rtwLevel - 1, 2 * square + ivec2(k & 1, k >> 1))]);
    }
    rtwDeepest[rtwDeepestPlace(rtwTexels, rtwLevel, square)] = deepest;
  }
}
