// Puts the clusters that a layer draws into a list, in their own order, so that they are drawn alike whenever that is done.
layout(local_size_x = 256) in;
layout(std430, binding = 3) readonly buffer BentEnds
{
  uint rtwBentEnds[]; // as rtwCullCasters.glsl writes them
};
layout(std430, binding = 4) writeonly buffer List
{
  uint rtwListed[2];  // how many; unused
  uvec2 rtwList[];    // the number of a draw, and the end of its indices that the warp may bend
};
uniform int rtwNumberOfDraws;
shared uint rtwPartial[256];

void main()
{
  int me = int(gl_LocalInvocationIndex);
  int each = (rtwNumberOfDraws + 255) / 256;
  int first = min(me * each, rtwNumberOfDraws);
  int end = min(first + each, rtwNumberOfDraws);
  uint mine = 0u;
  for (int i = first; i < end; ++i)
  {
    mine += rtwBentEnds[i] != 0u ? 1u : 0u;
  }
  rtwPartial[me] = mine;
  barrier();
  uint place = 0u;
  for (int i = 0; i < me; ++i)
  {
    place += rtwPartial[i];
  }
  for (int i = first; i < end; ++i)
  {
    if (rtwBentEnds[i] != 0u)
    {
      rtwList[place] = uvec2(i, rtwBentEnds[i] - 1u);
      ++place;
    }
  }
  if (me == 255)
  {
    rtwListed[0] = place;
  }
}
