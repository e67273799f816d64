// Which pixels are sampled: one of each square. Where in it the golden ratio says, from square to square, so that samples line up with
// nothing that the picture repeats, and what is too thin for one row of squares is met by another.
uniform int rtwStride; // pixels a side of a square, at most

ivec2 rtwSquares(ivec2 size)
{
  return (size + rtwStride - 1) / rtwStride;
}

struct SampledSquare
{
  ivec2 pixel;
  ivec2 low;
  ivec2 extent;
};

SampledSquare rtwSquareOf(ivec2 index, ivec2 size)
{
  SampledSquare square;
  ivec2 squares = rtwSquares(size);
  square.low = index * size / squares;
  square.extent = (index + 1) * size / squares - square.low;
  square.pixel = square.low + ivec2(fract(vec2(index.yx) * 0.61803399) * vec2(square.extent));
  return square;
}
