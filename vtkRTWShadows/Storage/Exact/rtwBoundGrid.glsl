// The bounds of what isn't in shadow yet: those of texels from their samples, those of squares from their four parts.
layout(local_size_x = 64) in;
layout(std430, binding = 4) readonly buffer Listed
{
  vec4 rtwListed[];
};
uniform int rtwLevel;

const uint MOST_SAMPLES = 8192u; // the samples of a texel that are looked at; llvmpipe ends loops after 65535

void rtwExtend(inout GridNode node, vec2 low, vec2 high, float deepest)
{
  node.low = min(node.low, low);
  node.high = max(node.high, high);
  node.deepest = max(node.deepest, deepest);
}

void main()
{
  uint i = rtwInvocation();
  if (i >= 1u << uint(2 * (rtwTopLevel - rtwLevel)))
  {
    return;
  }
  uint place = rtwLevelStart(rtwLevel) + i;
  uint first = rtwNodes[place].first;
  uint count = rtwNodes[place].count;
  GridNode node = GridNode(vec2(1e30), vec2(-1e30), NO_DEPTH, first, count, 0u);
  if (rtwLevel > 0)
  {
    uint child = rtwLevelStart(rtwLevel - 1) + 4u * i;
    for (uint k = child; k < child + 4u && count > 0u; ++k)
    {
      rtwExtend(node, rtwNodes[k].low, rtwNodes[k].high, rtwNodes[k].deepest);
    }
  }
  else if (count > MOST_SAMPLES)
  {
    rtwExtend(node, vec2(-1e30), vec2(1e30), 1e30);
  }
  else
  {
    for (uint k = first; k < first + count; ++k)
    {
      vec3 s = rtwListed[k].xyz;
      if (s.z > NO_DEPTH)
      {
        rtwExtend(node, s.xy, s.xy, s.z);
      }
    }
  }
  rtwNodes[place] = node;
}
