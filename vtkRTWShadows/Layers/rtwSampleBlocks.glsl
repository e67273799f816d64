// Samples in blocks: what is known of a block spares looking at its samples.
const int BLOCK = 4; // samples a side
const int BLOCK_SAMPLES = BLOCK * BLOCK;

ivec2 rtwBlocks()
{
  return (rtwSquares(textureSize(rtwSamples, 0)) + BLOCK - 1) / BLOCK;
}

// The sample at the low corner of a block.
ivec2 rtwCornerOf(int block)
{
  int width = rtwBlocks().x;
  return BLOCK * ivec2(block % width, block / width);
}

// Whether the sample of that number in the block at `corner` exists, and isn't beyond the view.
bool rtwIsOfBlock(ivec2 corner, int number, out ivec2 index)
{
  index = corner + ivec2(number % BLOCK, number / BLOCK);
  return all(lessThan(index, rtwSquares(textureSize(rtwSamples, 0))));
}
