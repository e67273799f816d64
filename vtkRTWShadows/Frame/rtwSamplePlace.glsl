// Which pixels are sampled: one of each square. Where in it the golden ratio says, from square to square, so that samples line up with
// nothing that the picture repeats, and what is too thin for one row of squares is met by another.
uniform int rtwStride; // pixels a side of a square, at most

// The exact quotient of integers that aren't negative, by floats: integer division is slow where vectors are divided
// one component at a time.
ivec2 rtwDivided(ivec2 a, ivec2 b)
{
  ivec2 about = ivec2(vec2(a) / vec2(b)); // off by less than one
  ivec2 rest = a - about * b;
  return about + ivec2(greaterThanEqual(rest, b)) - ivec2(lessThan(rest, ivec2(0)));
}

ivec2 rtwSquares(ivec2 size)
{
  return rtwDivided(size + rtwStride - 1, ivec2(rtwStride));
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
  square.low = rtwDivided(index * size, squares);
  square.extent = rtwDivided((index + 1) * size, squares) - square.low;
  square.pixel = square.low + ivec2(fract(vec2(index.yx) * 0.61803399) * vec2(square.extent));
  return square;
}
