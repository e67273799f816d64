// Forward analysis (Rosen 2012, section 4.1): each texel of the light's depth image asks for the pixels that it covers.
// A texel near the camera may stand for a million times as many pixels as one far from it, so that sums need 64 bits
// from the start.
void rtwAddLarge(uint at, float value)
{
  float scaled = min(value * FORWARD_UNIT, 1e15);
  float high = floor(scaled / 4294967296.0);
  rtwAddToProfile(at, uint(scaled - high * 4294967296.0), uint(high));
}

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  vec4 focus = rtwFocus(rtwLayer);
  if (any(greaterThanEqual(texel, rtwImageSize())))
  {
    return;
  }
  LitSample s = rtwLoadTexel(texel, focus);
  if (!s.used)
  {
    return;
  }
  ivec2 cell = rtwCell(rtwFocused(focus, s.onLight));
  bool edge = !rtwIsOn(SHADOW_EDGE) || rtwAtShadowEdge(s, focus);
  vec2 asked = rtwAsked(s, focus, edge);
  for (int axis = 0; axis < 2; ++axis)
  {
    if (!rtwIsSum())
    {
      atomicMax(rtwProfile[rtwPlace(0, axis, cell[axis])], floatBitsToUint(asked[axis]));
      continue;
    }
    rtwAddLarge(rtwPlace(0, axis, cell[axis]), asked[axis] * s.pixels);
    if (PROFILES == 2 && edge)
    {
      rtwAddLarge(rtwPlace(PROFILES - 1, axis, cell[axis]), asked[axis] * s.pixels);
    }
  }
}
