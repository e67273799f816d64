// The bounds of a layer: of all view samples in it that the light can reach (the desired view: Rosen 2012, section 5.1; Milet et al. 2015,
// section 3.3), from those of blocks. What has to be looked at sample by sample is put in a list: in the first pass blocks that lie in the
// layer only in part, in the second those that might hold more than was found.
layout(local_size_x = 256) in;
layout(std430, binding = 1) readonly buffer Blocks
{
  vec4 rtwBlockValues[]; // as rtwBoundBlocks.glsl writes them
};
layout(std430, binding = 2) buffer Visits
{
  // For each pass: three numbers of work groups, the length of its list; then the lists, as rtwVisitBlocks.glsl reads
  // them.
  uint rtwVisits[];
};
layout(std430, binding = 4) buffer BlockLists
{
  uint rtwBlockLists[]; // as rtwVisitSamples.glsl has them; all headers stand first
};
uniform int rtwFirstBlock;
uniform int rtwNumberOfBlocks;
uniform int rtwPass;
uniform int rtwFirstList; // where the first layer's list begins; below 0 no lists are made
uniform int rtwParts;     // layers of the light
shared vec4 rtwPartial[256];
shared uint rtwTaken;
shared uint rtwPlaceOfTaken;

const int BLOCKS = 8; // blocks of each invocation

int rtwBlockOf(int k)
{
  return (int(gl_WorkGroupID.x) * BLOCKS + k) * 256 + int(gl_LocalInvocationIndex);
}

// Reduces the bounds of all invocations to the first one's place.
void rtwReduce(vec4 mine)
{
  uint me = gl_LocalInvocationIndex;
  rtwPartial[me] = mine;
  barrier();
  for (uint step = 128u; step > 0u; step /= 2u)
  {
    if (me < step)
    {
      rtwPartial[me] = rtwUnited(rtwPartial[me], rtwPartial[me + step]);
    }
    barrier();
  }
}

// Appends the blocks of an invocation, given as bits, to a layer's list. To be called by all invocations.
void rtwList(int layer, uint mine)
{
  uint me = gl_LocalInvocationIndex;
  if (me == 0u)
  {
    rtwTaken = 0u;
  }
  barrier();
  uint place = mine != 0u ? atomicAdd(rtwTaken, uint(bitCount(mine))) : 0u;
  barrier();
  if (me == 0u && rtwTaken > 0u)
  {
    rtwPlaceOfTaken = atomicAdd(rtwBlockLists[4 * layer + 3], rtwTaken);
    atomicMax(rtwBlockLists[4 * layer], (rtwPlaceOfTaken + rtwTaken + 255u) / 256u);
  }
  barrier();
  uint first = uint(rtwFirstList + layer * rtwNumberOfBlocks) + rtwPlaceOfTaken + place;
  for (; mine != 0u; mine &= mine - 1u)
  {
    rtwBlockLists[first] = uint(rtwBlockOf(findLSB(mine)));
    ++first;
  }
}

void rtwAskForVisit(int part, int block)
{
  uint place = atomicAdd(rtwVisits[4 * rtwPass + 3], 1u);
  atomicMax(rtwVisits[4 * rtwPass], (place + 64u) / 64u);
  rtwVisits[8u + place] = uint(part * rtwNumberOfBlocks + block);
}

void main()
{
  int part = int(gl_WorkGroupID.y);
  int layer = rtwLayer + part;
  vec2 interval = rtwParts == 1 ? vec2(-1.0, 1e38) : vec2(rtwBlendStart(layer), rtwIntervalOf(layer).y);
  uint mine = 0u;
  vec4 held = NOTHING;
  for (int k = 0; k < BLOCKS; ++k)
  {
    int block = rtwBlockOf(k);
    int place = 3 * (rtwFirstBlock + min(block, rtwNumberOfBlocks - 1));
    vec2 depths = rtwBlockValues[place + 2].xy;
    bool touches = block < rtwNumberOfBlocks && depths.x <= depths.y && depths.y >= interval.x && depths.x < interval.y;
    bool whole = touches && rtwFaces == 1 && depths.x >= interval.x && depths.y < interval.y;
    bool visit = rtwPass == 0 ? touches && !whole : touches && !rtwIsSettled(layer, rtwBlockValues[place + 1]);
    held = whole ? rtwUnited(held, rtwBlockValues[place]) : held;
    mine |= touches ? 1u << k : 0u;
    if (visit)
    {
      rtwAskForVisit(part, block);
    }
  }
  if (rtwPass == 0)
  {
    rtwReduce(held);
    if (gl_LocalInvocationIndex == 0u && rtwPartial[0].x <= rtwPartial[0].z)
    {
      rtwAddBounds(layer, rtwKept(rtwPartial[0]), 0);
    }
  }
  if (rtwPass == 0 && rtwFirstList >= 0)
  {
    rtwList(layer, mine);
  }
}
