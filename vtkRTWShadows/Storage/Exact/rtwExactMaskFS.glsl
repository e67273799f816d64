// The mask from what is known of each pixel, and from the maps of casters that only VTK's mappers can draw.
layout(std430, binding = 2) readonly buffer States
{
  uint rtwStates[];
};
out vec4 mask;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint state = rtwStates[pixel.y * textureSize(rtwSamples, 0).x + pixel.x];
  int facing = bitCount(state >> STATE_FACES);
  float visibility = RTW_NOT_LIT;
  if (facing > 0)
  {
    float others = rtwOthers(rtwLoadPlane(pixel));
    visibility = 1.0 - float(bitCount(state & STATE_SAMPLES)) / float(facing);
    visibility = others == RTW_NOT_LIT ? visibility : min(visibility, others);
  }
  mask = vec4(rtwMaskValue(visibility));
}
