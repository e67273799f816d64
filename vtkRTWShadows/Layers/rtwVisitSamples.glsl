// An invocation goes through the samples of one block: of all blocks one after another, or of those in which a layer
// has samples.
layout(std430, binding = 4) readonly buffer BlockLists
{
  uint rtwBlockLists[]; // for each list: three numbers of work groups, its length; its blocks
};
uniform int rtwBlockList;      // where the layer's list begins; below 0 there is none
uniform int rtwListedBlocks;   // where the list's blocks begin

// What a stage does with a sample of the layer that the light reaches.
void rtwVisit(LitSample s);

// A work group's 4096 samples.
void rtwVisitTile()
{
  int number = int(gl_WorkGroupID.x * 256u + gl_LocalInvocationIndex);
  bool listed = rtwBlockList >= 0;
  ivec2 all = rtwBlocks();
  int count = listed ? int(rtwBlockLists[rtwBlockList + 3]) : all.x * all.y;
  bool any = number < count;
  int block = any && listed ? int(rtwBlockLists[rtwListedBlocks + number]) : number;
  ivec2 corner = rtwCornerOf(block);
  for (int i = 0; i < BLOCK_SAMPLES; ++i)
  {
    ivec2 index;
    if (any && rtwIsOfBlock(corner, i, index))
    {
      LitSample s = rtwLoadSample(index);
      if (s.used && rtwIsOfLayer(s.position))
      {
        rtwVisit(s);
      }
    }
  }
}
