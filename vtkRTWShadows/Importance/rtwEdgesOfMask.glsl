// Shadow edges are where the last frame's mask held both light and shadow, around the pixel that showed this sample then.
uniform sampler2DArray rtwLastMask;
uniform mat4 rtwViewToLastClip;
uniform int rtwMaskLayer;
uniform int rtwHasMask;

// Whether a sample was beside a shadow edge; true where the last frame doesn't tell.
bool rtwAtShadowEdge(LitSample s, vec4 focus)
{
  ivec2 last = textureSize(rtwLastMask, 0).xy - 1;
  vec4 clip = rtwViewToLastClip * vec4(s.position, 1.0);
  vec2 at = 0.5 + 0.5 * clip.xy / clip.w;
  if (rtwHasMask == 0 || clip.w <= 0.0 || any(notEqual(clamp(at, 0.0, 1.0), at)))
  {
    return true;
  }
  ivec2 pixel = min(ivec2(at * vec2(last + 1)), last);
  bool known = false;
  bvec2 lit = bvec2(false);
  for (int k = 0; k < 9; ++k)
  {
    ivec2 other = clamp(pixel + ivec2(k % 3, k / 3) - 1, ivec2(0), last);
    float value = 255.0 * texelFetch(rtwLastMask, ivec3(other, rtwMaskLayer), 0).r;
    lit.x = lit.x || value < 127.5;
    lit.y = lit.y || value > 128.5;
    known = known || (k == 4 && (value < 127.5 || value > 128.5));
  }
  return !known || all(lit);
}
