// A layer's rows in the warp table, and its focus: where on the light plane its map lies.
//
// Rows of a layer: forward along s, forward along t, inverse along s, inverse along t. Behind the last cell of the first two
// stands the focus along that axis: its low end, and one over its extent; then what rtwLayerInterval.glsl has.
#if defined(RTW_TABLE_IN_UNIFORMS)
// The rows of the layer that is worked on are two blocks, since one would be longer than a block may be. LayerTable
// binds both.
layout(std140) uniform WarpForward
{
  vec4 rtwForwardPairs[4096];
};
layout(std140) uniform WarpInverse
{
  vec4 rtwInversePairs[4096];
};
#elif defined(RTW_TABLE_IN_STORAGE)
layout(std430, binding = 7) readonly buffer WarpTable
{
  vec2 rtwWarpTable[];
};
#else
uniform samplerBuffer rtwWarpTable;
#endif
uniform ivec2 rtwWarpSize; // cells of a warping function, places of its inverse: texels of a side where the map is square
uniform int rtwWarpedLayers; // layers from that number on have no warp
uniform ivec2 rtwMapSize;  // texels of the map along s and t, which are as many unless the warp is perspective

int rtwWarpPlace(int row, int i)
{
  return row * ((max(rtwWarpSize.x + 2, rtwWarpSize.y) + 1) & ~1) + i;
}

vec2 rtwWarpEntry(int row, int i)
{
#if defined(RTW_TABLE_IN_UNIFORMS)
  int place = rtwWarpPlace(row & 1, i);
  vec4 two = (row & 2) == 0 ? rtwForwardPairs[place >> 1] : rtwInversePairs[place >> 1];
  return (place & 1) == 0 ? two.xy : two.zw;
#elif defined(RTW_TABLE_IN_STORAGE)
  return rtwWarpTable[rtwWarpPlace(row, i)];
#else
  return texelFetch(rtwWarpTable, rtwWarpPlace(row, i)).rg;
#endif
}

vec4 rtwFocus(int layer)
{
  return vec4(rtwWarpEntry(4 * layer, rtwWarpSize.x), rtwWarpEntry(4 * layer + 1, rtwWarpSize.x));
}

vec2 rtwFocused(vec4 focus, vec2 onLight)
{
  return (onLight - focus.xz) * focus.yw;
}

// Focus coordinates of the centres of a texel, of the one to its right, of the one above, and of the one above the
// latter.
struct TexelCentres
{
  vec2 here;
  vec2 right;
  vec2 above;
  vec2 beyond;
};
