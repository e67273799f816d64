// Each sample of a pixel sees a surface of its own; its plane is that of the pixel's centre.
uniform sampler2DMS rtwManySamples;

vec4 rtwSampleOf(ivec2 pixel, int point)
{
  return texelFetch(rtwManySamples, pixel, point);
}
