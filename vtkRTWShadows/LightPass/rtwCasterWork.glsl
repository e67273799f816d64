// A cluster on its way through the light pass: what the culling leaves of it, and the draw calls that its triangles' set-up fills.
//
// Each cluster has its own place in the lists of triangles, so that they are drawn in the same order whenever they are set up.
struct CasterWork
{
  uint straightDraw[4]; // vertices, instances, first vertex, first instance
  uint bentDraw[4];
  uint planeDraw[4];
  uint patchDraw[4 * PATCH_CLASSES]; // a draw call for each class of patches
  uint firstIndex;
  uint baseVertex;
  uint instance;
  uint bentEnd; // of the indices of triangles that the warp may bend; they come first
  uint end;     // of all indices
  uint slices;  // number of covers that are slices
  uint numberOfCasters;
  uint patches; // number of patches of tessellated triangles
  uint casters[MOST_TRIANGLES]; // triangles that hide the centre of a texel; IS_COVERED is added to those whose tiles are to be found
};
const uint IS_COVERED = 65536u;

layout(std430, binding = 3) buffer Work
{
  CasterWork rtwWork[];
};
