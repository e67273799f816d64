// The bounds of each block of view samples that the light can reach, and between which distances along the view direction, from where view
// coordinates begin, they lie.
layout(local_size_x = 256) in;
layout(std430, binding = 1) writeonly buffer Blocks
{
  // For each block: bounds of its samples; bounds of what all their pixels might hold; nearest and farthest distance.
  vec4 rtwBlockValues[];
};
layout(std430, binding = 2) buffer Range
{
  // For each light: nearest and farthest distance, as the bits of positive floats, which have the floats' order.
  uint rtwRange[];
};
uniform int rtwFirstBlock;
uniform int rtwLight;
shared uint rtwNearestBits;
shared uint rtwFarthestBits;

void rtwBound(int block)
{
  vec4 seen = NOTHING;
  vec4 maybe = NOTHING;
  vec2 depths = vec2(1e30, 0.0);
  ivec2 corner = rtwCornerOf(block);
  for (int i = 0; i < BLOCK_SAMPLES; ++i)
  {
    ivec2 index;
    bool any = rtwIsOfBlock(corner, i, index);
    LitSample s = rtwLoadSample(index);
    if (any && s.used)
    {
      seen = rtwUnited(seen, rtwHeld(s));
      maybe = rtwUnited(maybe, rtwHeldMaybe(s));
      depths = vec2(min(depths.x, max(-s.position.z, 0.0)), max(depths.y, -s.position.z));
    }
  }
  int place = 3 * (rtwFirstBlock + block);
  rtwBlockValues[place] = seen;
  rtwBlockValues[place + 1] = rtwKept(maybe);
  rtwBlockValues[place + 2] = vec4(depths, 0.0, 0.0);
  if (depths.x <= depths.y)
  {
    atomicMin(rtwNearestBits, floatBitsToUint(depths.x));
    atomicMax(rtwFarthestBits, floatBitsToUint(depths.y));
  }
}

void main()
{
  if (gl_LocalInvocationIndex == 0u)
  {
    rtwNearestBits = floatBitsToUint(1e30);
    rtwFarthestBits = 0u;
  }
  barrier();
  ivec2 all = rtwBlocks();
  int block = int(gl_GlobalInvocationID.x);
  if (block < all.x * all.y)
  {
    rtwBound(block);
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u && rtwFarthestBits != 0u)
  {
    atomicMin(rtwRange[2 * rtwLight], rtwNearestBits);
    atomicMax(rtwRange[2 * rtwLight + 1], rtwFarthestBits);
  }
}
