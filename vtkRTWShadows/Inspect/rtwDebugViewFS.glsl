// Debug views, painted over what is drawn of the view samples: as they are or, in a multisampled target, over all that a pixel shows
// of them.
uniform int rtwDebugView;
uniform int rtwOtherLayers;
uniform ivec2 rtwOrigin; // the viewport's corner in the target, in pixels
uniform int rtwReach;    // distance, in pixels, of the pixels around whose depth counts too: 0 or 1
uniform sampler2DArray rtwMask;
uniform int rtwMaskLayer;
out vec4 colour;

const float THIN = 64.0; // lines of the grid, over the map
const float WIDE = 8.0;
const int STRIPE = 6; // in pixels

vec3 rtwShadowColour(ivec2 pixel)
{
  float value = texelFetch(rtwMask, ivec3(pixel, rtwMaskLayer), 0).r;
  bool neither = abs(255.0 * value - 128.0) < 0.5;
  return neither ? NEITHER : mix(vec3(0.08, 0.10, 0.28), vec3(1.00, 0.95, 0.75), rtwMaskedVisibility(value));
}

vec3 rtwAliasingColour(MapSample m)
{
  vec2 error = rtwAliasing(m);
  return rtwOnScale(ALIASING, max(error.x, error.y));
}

// The colour of the number of texels along a length, in units of the mean; the number in an area is the square of that.
vec3 rtwDensityColour(MapSample m)
{
  return rtwOnScale(DENSITY, sqrt(abs(determinant(rtwWarpSlope(m.layer, m.q)))));
}

// Two layers that are both looked up share the surface in stripes.
vec3 rtwLayersColour(ivec2 pixel, MapSample m)
{
  bool other = rtwOtherLayers > 0 && ((pixel.x + pixel.y) / STRIPE) % 2 == 1;
  int layer = other ? m.layer + rtwOtherLayers : m.layer;
  bool isOnMap = all(equal(clamp(m.q, 0.0, 1.0), m.q));
  return isOnMap ? (0.4 + 0.6 * m.facing) * LAYER[layer % 6] : NEITHER;
}

// The share of the pixel that lines across s and t cover, which are as wide on the screen everywhere; none where they
// are too dense to tell.
vec2 rtwLines(MapSample m, float lines, float width)
{
  vec2 at = lines * rtwWarp(m.layer, m.q);
  vec2 nearest = floor(at + 0.5);
  vec2 pixel = max(rtwPixelOnMap(m, vec2(lines)), 1e-30);
  vec2 cover = clamp(0.5 * width + 0.5 - abs(at - nearest) / pixel, 0.0, 1.0);
  cover *= vec2(greaterThanEqual(nearest, vec2(0.0))) * vec2(lessThanEqual(nearest, vec2(lines)));
  return cover * (1.0 - smoothstep(0.6, 1.2, width * pixel));
}

vec4 rtwGridColour(MapSample m)
{
  vec2 cover = max(rtwLines(m, THIN, 1.0), rtwLines(m, WIDE, 2.5));
  vec3 s = vec3(0.95, 0.45, 0.05);
  vec3 t = vec3(0.05, 0.55, 0.95);
  return vec4(mix(s, t, cover.y / max(cover.x + cover.y, 1e-3)), max(cover.x, cover.y));
}

// The least depth of what is drawn at a pixel: that of the nearest of the samples around.
float rtwDrawnDepth(ivec2 pixel)
{
  ivec2 last = textureSize(rtwSamples, 0) - 1;
  float depth = 1.0;
  for (int y = -rtwReach; y <= rtwReach; ++y)
  {
    for (int x = -rtwReach; x <= rtwReach; ++x)
    {
      float a = texelFetch(rtwSamples, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).x;
      depth = a > 0.0 ? min(depth, rtwSampleDepth(a)) : depth;
    }
  }
  return depth;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - rtwOrigin;
  MapSample m = rtwLoadMapSample(pixel);
  if (!m.seen || (rtwDebugView == WARP_GRID && !m.lit))
  {
    discard;
  }
  colour = vec4(NEITHER, 1.0);
  if (rtwDebugView == WARP_GRID)
  {
    colour = rtwGridColour(m);
  }
  else if (rtwDebugView == SHADOW)
  {
    colour.rgb = rtwShadowColour(pixel);
  }
  else if (m.lit)
  {
    colour.rgb = rtwDebugView == ALIASING_ERROR ? rtwAliasingColour(m)
      : rtwDebugView == IMPORTANCE              ? rtwDensityColour(m)
                                                : rtwLayersColour(pixel, m);
  }
  gl_FragDepth = rtwDrawnDepth(pixel);
}
