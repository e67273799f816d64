// Shadow edges are where the depth of the light's image is discontinuous between a texel and one of its eight neighbours (Rosen 2012,
// section 5.3). What the slope of either surface explains is no step, so that a low threshold finds small ones and no slopes.
uniform vec3 rtwEdgeDepth; // least difference of depth at an edge: x times the square of (y + z · depth)

bool rtwAtShadowEdge(LitSample s, vec4 focus)
{
  ivec2 last = rtwImageSize() - 1;
  ivec2 texel = clamp(ivec2(rtwFocused(focus, s.onLight) * vec2(last + 1)), ivec2(0), last);
  float here = rtwImageDepth(texel);
  vec2 slope = rtwImageGradient(texel);
  float inverse = rtwEdgeDepth.y + rtwEdgeDepth.z * here;
  float differs = rtwEdgeDepth.x * inverse * inverse;
  // A texel in which the light meets nothing although there is a sample is crossed by a border.
  bool edge = here >= 1.0;
  for (int k = 0; k < 9; ++k)
  {
    ivec2 other = clamp(texel + ivec2(k % 3, k / 3) - 1, ivec2(0), last);
    vec2 away = vec2(other - texel) / vec2(last + 1);
    float rise = rtwImageDepth(other) - here;
    float step = min(abs(rise - dot(slope, away)), abs(rise - dot(rtwImageGradient(other), away)));
    edge = edge || step >= differs;
  }
  return edge;
}
