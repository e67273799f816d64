// A bit for each sample of a pixel: from bit 0 those in shadow, from STATE_FACES on those that face the light. Maps decide sample by
// sample too.
layout(std430, binding = 2) readonly buffer States
{
  uint rtwStates[];
};
uniform int rtwSamplesAPixel;
uniform vec2 rtwOffsets[8]; // places of a pixel's samples from its centre, in pixels
out uint bits;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  bits = rtwStates[pixel.y * textureSize(rtwSamples, 0).x + pixel.x];
  for (int point = 0; point < rtwSamplesAPixel; ++point)
  {
    bool faces = (bits >> (STATE_FACES + uint(point)) & 1u) != 0u;
    float others = rtwOthers(rtwPlaneAt(rtwSampleOf(pixel, point), pixel, rtwOffsets[point]));
    bits |= faces && others != RTW_NOT_LIT && others < 0.5 ? 1u << uint(point) : 0u;
  }
}
