// All points of a pixel see the surface at its centre.
vec4 rtwSampleOf(ivec2 pixel, int point)
{
  return texelFetch(rtwSamples, pixel, 0);
}
