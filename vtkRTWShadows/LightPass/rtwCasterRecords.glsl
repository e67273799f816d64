// Triangles that are ready to be drawn, as the set-up writes them and the vertex shaders read them.
struct StraightCaster
{
  vec2 onMap[3];
  float depth[3];  // at the three corners; or, where fragments take depth from the plane, q and depth of one corner
  vec2 slope;      // of depth, in focused light-plane coordinates
  vec2 depthRange; // least and greatest depth, where fragments take depth from the plane
};

struct BentCaster
{
  // Signed distance from each edge, as its product with (q - anchor, 1); w: the slope of depth, and the least depth.
  vec4 edges[3];
  vec4 anchor;   // a corner: q and depth; w: the greatest depth
  // The rest is only for a triangle that is covered by tiles.
  // q of two corners; q of the third, and whether it crosses the plane of a spot: then three corners of its bounds
  vec4 corners[2];
  vec4 texels;     // the texels whose centres it can hide: first, last
  vec4 unused;
};

// A bent triangle that is tessellated takes the same place: its corners before the perspective division in `edges`, and in `anchor` the
// slope and the numbers of pieces along an edge, in all, and of the edges from the first to the second corner, and so on: PIECES times
// the first of two, plus the other.
const float PIECES = 1024.0;


// A part of the map that holds a bent triangle, or a slice of one: a triangle, or the parallelogram that it is half of. Or a patch, by its
// corners in pieces along the first two edges from the first corner; `depth` is its own number of pieces along an edge then. Corners of a
// triangle that is a single piece are on the map. Patches lie behind the covers, class by class.
struct CasterCover
{
  vec2 corners[3];
  uint caster; // twice its index, and 1 for a parallelogram
  float depth;
};
