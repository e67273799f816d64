// What a map's texels cost the picture, added up over a square of pixels: a shadow edge is misplaced by about a texel, so that the pixels
// beside it are the more likely to be wrong the more pixels that is.
uniform sampler2DArray rtwMask;    // shadows of all casters
uniform sampler2DArray rtwOwnMask; // shadows of the casters in the light's own layer alone
uniform int rtwMaskLayer;   // the light's layer of both masks
uniform int rtwOtherLayers; // how far behind it the layer of the other casters lies; 0: there is none
out vec4 sums; // over pixels beside an edge: the pixels that it moves by, and 1; and over all that face the light: 1

const float WIDEST = 50.0; // pixels that an edge can move by at most

vec3 rtwSumsOf(ivec2 pixel)
{
  if (rtwDecision(rtwMask, rtwMaskLayer, pixel) == 0.5)
  {
    return vec3(0.0);
  }
  if (!rtwBesideEdge(rtwMask, rtwMaskLayer, pixel))
  {
    return vec3(0.0, 0.0, 1.0);
  }
  bool others = rtwOtherLayers > 0 && !rtwBesideEdge(rtwOwnMask, rtwMaskLayer, pixel);
  MapSample m = rtwLoadMapSample(pixel);
  mat2 moves = rtwMovesOnMap(others ? m.layer + rtwOtherLayers : m.layer, m, vec2(rtwMapSize));
  float moved = rtwMisplaced(moves[0], moves[1], rtwEdgeNormal(rtwMask, rtwMaskLayer, pixel), vec2(1.0));
  return vec3(moved < WIDEST ? moved : WIDEST, 1.0, 1.0);
}

void main()
{
  ivec2 corner = RTW_SQUARE * ivec2(gl_FragCoord.xy);
  ivec2 end = min(corner + RTW_SQUARE, textureSize(rtwMask, 0).xy);
  sums = vec4(0.0);
  for (int y = corner.y; y < end.y; ++y)
  {
    for (int x = corner.x; x < end.x; ++x)
    {
      sums.xyz += rtwSumsOf(ivec2(x, y));
    }
  }
}
