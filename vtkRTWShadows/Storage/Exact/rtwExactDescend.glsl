// A square that a triangle meets is replaced by those of its four parts that the triangle meets too.
layout(local_size_x = 64) in;
uniform int rtwStep;

void main()
{
  uint i = gl_GlobalInvocationID.x;
  if (i >= rtwItems(uint(rtwStep)))
  {
    return;
  }
  uint place = rtwQueuePlace(uint(rtwStep), i);
  uint caster = rtwQueue[place];
  uint item = rtwQueue[place + 1u];
  uint level = item >> LEVEL_SHIFT;
  uint within = (item & (1u << LEVEL_SHIFT) - 1u) - rtwLevelStart(int(level));
  uint child = rtwLevelStart(int(level) - 1) + 4u * within;
  ExactCaster t = rtwExactCasters[caster];
  for (uint k = child; k < child + 4u; ++k)
  {
    if (rtwNodes[k].count > 0u && rtwMeets(t, rtwNodes[k]))
    {
      rtwPushNode(uint(rtwStep) + 1u, caster, k, level - 1u);
    }
  }
}
