// The buffers that the set-up of a bent triangle writes it to, and the parts of the map that hold it.
layout(std430, binding = 5) writeonly buffer BentCasters
{
  BentCaster rtwBent[];
};
layout(std430, binding = 6) writeonly buffer Covers
{
  CasterCover rtwCovers[];
};

void rtwAddCover(uint caster, vec2 a, vec2 b, vec2 c, float depth)
{
  uint i = MOST_COVERS * gl_WorkGroupID.x + atomicAdd(rtwWork[gl_WorkGroupID.x].bentDraw[0], 6u) / 6u;
  rtwCovers[i].corners[0] = a;
  rtwCovers[i].corners[1] = b;
  rtwCovers[i].corners[2] = c;
  rtwCovers[i].caster = caster;
  rtwCovers[i].depth = depth;
}

void rtwAddBox(uint caster, vec2 low, vec2 high, float depth)
{
  rtwAddCover(2u * caster + 1u, low, vec2(high.x, low.y), vec2(low.x, high.y), depth);
}
