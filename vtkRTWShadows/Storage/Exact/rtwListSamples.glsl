// Writes each sample into its texel's part of the list.
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Found
{
  vec4 rtwFound[];
};
layout(std430, binding = 1) readonly buffer Places
{
  uvec2 rtwPlaces[];
};
layout(std430, binding = 4) writeonly buffer Listed
{
  vec4 rtwListed[];
};
layout(std430, binding = 5) writeonly buffer Owners
{
  uint rtwOwners[]; // for each listed sample: its pixel, and which of the pixel's samples it is
};
uniform int rtwNumberOfSamples;
uniform int rtwSamplesAPixel;

const uint NOWHERE = 0xffffffffu;

void main()
{
  uint i = rtwInvocation();
  uvec2 place = i < uint(rtwNumberOfSamples) ? rtwPlaces[i] : uvec2(NOWHERE);
  if (place.x == NOWHERE)
  {
    return;
  }
  uint to = rtwNodes[place.x].first + place.y;
  uint pixel = i / uint(rtwSamplesAPixel);
  rtwListed[to] = rtwFound[i];
  rtwOwners[to] = pixel | (i - pixel * uint(rtwSamplesAPixel)) << OWNER_PIXEL_BITS;
}
