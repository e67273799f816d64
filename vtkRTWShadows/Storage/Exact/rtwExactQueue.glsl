// What the exact test has still to do. The queue begins with a command for each step (groups, 1, 1, items), then come the items, in two
// parts that steps fill and empty alternately, and those of the test.
layout(std430, binding = 6) buffer Queue
{
  uint rtwQueue[];
};
uniform int rtwQueueCapacity; // items of each part

const uint GROUP = 64u;
const uint TEST = 16u;       // the step after all others
const uint CLUSTERS = 17u;   // the step that goes through the clusters that are kept
const uint OVERFLOW = 79u;   // whether anything was left out, ever
const uint QUEUE_START = 80u;
// Low bits of a test, which hold the number of samples; the others hold the first one's number.
const uint CHUNK_BITS = 6u;
const uint CHUNK = 1u << CHUNK_BITS;
const uint LEVEL_SHIFT = 27u; // the place of the level in a node's number

uint rtwQueuePlace(uint step, uint i)
{
  uint part = step == TEST ? 2u : step & 1u;
  return QUEUE_START + 2u * (part * uint(rtwQueueCapacity) + i);
}

uint rtwItems(uint step)
{
  return min(rtwQueue[4u * step + 3u], uint(rtwQueueCapacity));
}

void rtwPush(uint step, uint caster, uint what)
{
  uint i = atomicAdd(rtwQueue[4u * step + 3u], 1u);
  if (i >= uint(rtwQueueCapacity))
  {
    rtwQueue[OVERFLOW] = 1u;
    return;
  }
  uint place = rtwQueuePlace(step, i);
  rtwQueue[place] = caster;
  rtwQueue[place + 1u] = what;
  if (i % GROUP == 0u)
  {
    atomicMax(rtwQueue[4u * step], i / GROUP + 1u);
  }
}
