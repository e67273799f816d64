// What a map's texels cost the picture, added up over a square of pixels: a shadow edge is misplaced by about a texel, so that the pixels
// beside it are the more likely to be wrong the more pixels that is.
uniform sampler2DArray rtwMask;    // of all casters
uniform sampler2DArray rtwOwnMask; // of those in the light's own layer
uniform int rtwMaskLayer;   // the light's, of both
uniform int rtwOtherLayers; // how far behind it the layer of the other casters lies; 0: there is none
out vec4 sums; // pixels that edges move by, and pixels, of those beside one; all pixels that face the light

const float WIDEST = 50.0; // what is wrong cannot be more so

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
