// A grid whose texels hold the view samples that fall on them: texels in Morton order, and above them squares of 2, 4, 8 … texels a side,
// so that the samples of a square lie side by side in the list, whatever the warp is.
struct GridNode
{
  vec2 low; // bounds of its samples on the light plane
  vec2 high;
  float deepest; // depth of its deepest sample that isn't in shadow yet; NO_DEPTH where there is none
  uint first;    // place of its first sample in the list
  uint count;
  uint unused;
};

layout(std430, binding = 3) buffer GridNodes
{
  GridNode rtwNodes[];
};
uniform int rtwGridSide; // texels a side that the map is divided into
// Level of the pyramid's only square, of 2^rtwTopLevel texels a side, which is rtwGridSide at least.
uniform int rtwTopLevel;

const float NO_DEPTH = -1e30;

// Where the squares of a level begin; level 0 are the texels.
uint rtwLevelStart(int level)
{
  return ((4u << uint(2 * rtwTopLevel)) - (4u << uint(2 * (rtwTopLevel - level)))) / 3u;
}

uint rtwSpreadBits(uint x)
{
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

uint rtwMorton(uvec2 at)
{
  return rtwSpreadBits(at.x) | rtwSpreadBits(at.y) << 1;
}

// The texel that holds a point in map coordinates.
uint rtwTexelAt(vec2 onMap)
{
  float side = float(rtwGridSide);
  return rtwMorton(uvec2(clamp(floor(onMap * side), 0.0, side - 1.0)));
}
