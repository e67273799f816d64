// Where each texel's samples lie in the list: counts are added up from texels to the whole grid, then each square's place is divided
// among its four.
layout(local_size_x = 64) in;
uniform int rtwLevel; // the level that is written
uniform int rtwDown;

void main()
{
  uint i = rtwInvocation();
  if (i >= 1u << uint(2 * (rtwTopLevel - rtwLevel)))
  {
    return;
  }
  uint node = rtwLevelStart(rtwLevel) + i;
  if (rtwDown == 0)
  {
    uint child = rtwLevelStart(rtwLevel - 1) + 4u * i;
    rtwNodes[node].count = rtwNodes[child].count + rtwNodes[child + 1u].count + rtwNodes[child + 2u].count + rtwNodes[child + 3u].count;
    return;
  }
  uint first = rtwLevel < rtwTopLevel ? rtwNodes[rtwLevelStart(rtwLevel + 1) + (i >> 2)].first : 0u;
  for (uint k = i & 3u; k > 0u; --k)
  {
    first += rtwNodes[node - k].count;
  }
  rtwNodes[node].first = first;
}
