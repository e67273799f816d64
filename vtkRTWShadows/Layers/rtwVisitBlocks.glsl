// Looks at the samples of listed blocks, for a layer each: in the second pass at all their pixels, where they might hold more than was found.
layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Visits
{
  uint rtwVisits[]; // as rtwUniteBlocks.glsl writes them; a layer and a block in one number
};
uniform int rtwNumberOfBlocks;
uniform int rtwPass;
vec4 rtwSeen = NOTHING;

void rtwAdd(int layer, LitSample s)
{
  if (s.used && rtwBelongsTo(layer, s.position))
  {
    rtwSeen = rtwUnited(rtwSeen, rtwHeld(s));
  }
}

void rtwLookClosely(int layer, ivec2 index, LitSample s)
{
  SampledSquare square = rtwSquareOf(index, textureSize(rtwSamples, 0));
  bool needed = s.used && rtwBelongsTo(layer, s.position) && !rtwIsSettled(layer, rtwHeldMaybe(s));
  int pixels = needed ? square.extent.x * square.extent.y : 0;
  for (int k = 0; k < pixels; ++k)
  {
    rtwAdd(layer, rtwLoadPixel(square.low + ivec2(k % square.extent.x, k / square.extent.x)));
  }
}

void main()
{
  uint number = gl_GlobalInvocationID.x;
  if (number >= rtwVisits[4 * rtwPass + 3])
  {
    return;
  }
  int item = int(rtwVisits[8u + number]);
  int layer = rtwLayer + item / rtwNumberOfBlocks;
  ivec2 corner = rtwCornerOf(item % rtwNumberOfBlocks);
  for (int i = 0; i < BLOCK_SAMPLES; ++i)
  {
    ivec2 index;
    bool any = rtwIsOfBlock(corner, i, index);
    LitSample s = rtwLoadSample(index);
    s.used = any && s.used;
    if (rtwPass == 0)
    {
      rtwAdd(layer, s);
    }
    else
    {
      rtwLookClosely(layer, index, s);
    }
  }
  if (rtwSeen.x <= rtwSeen.z)
  {
    rtwAddBounds(layer, rtwKept(rtwSeen), rtwPass);
  }
}
