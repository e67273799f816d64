// A layer's rows in the warp table, and its focus: where on the light plane its map lies.
//
// Rows of a layer: forward along s, forward along t, inverse along s, inverse along t. Behind the last cell of the first two
// stands the focus along that axis: its low end, and one over its extent.
uniform sampler2D rtwWarpTable;
uniform ivec2 rtwWarpSize; // cells of a warping function, texels of the map

vec4 rtwFocus(int layer)
{
  return vec4(texelFetch(rtwWarpTable, ivec2(rtwWarpSize.x, 4 * layer), 0).rg,
    texelFetch(rtwWarpTable, ivec2(rtwWarpSize.x, 4 * layer + 1), 0).rg);
}

vec2 rtwFocused(vec4 focus, vec2 onLight)
{
  return (onLight - focus.xz) * focus.yw;
}
