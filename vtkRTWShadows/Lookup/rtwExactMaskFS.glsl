// The mask from what is known of each pixel, and from the maps of casters that only VTK's mappers can draw.
layout(std430, binding = 2) readonly buffer States
{
  uint rtwStates[];
};
uniform int rtwSamplesAPixel;
uniform int rtwHasMap;
out vec4 mask;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint state = rtwStates[pixel.y * textureSize(rtwSamples, 0).x + pixel.x];
  float visibility = RTW_NOT_LIT;
  if (state != 0u)
  {
    visibility = 1.0 - float(bitCount(state & (STATE_FACES - 1u))) / float(rtwSamplesAPixel);
  }
  if (state != 0u && rtwHasMap != 0)
  {
    SampledPlane plane = rtwLoadPlane(pixel);
    vec4 here = rtwOnLightPlane(0, plane.here);
    vec3 dx = rtwOnLightPlane(0, plane.right).xyz - here.xyz;
    vec3 dy = rtwOnLightPlane(0, plane.above).xyz - here.xyz;
    float others = rtwVisibility(0, here, dx, dy, plane.here);
    visibility = others == RTW_NOT_LIT ? visibility : min(visibility, others);
  }
  mask = vec4(rtwMaskValue(visibility));
}
