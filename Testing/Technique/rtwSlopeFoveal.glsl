// How far a point moves on the map while it moves over the focus: the columns are along s and t.
mat2 rtwWarpSlope(int layer, vec2 q)
{
  if (layer >= rtwWarpedLayers)
  {
    return mat2(1.0);
  }
  vec2 u = FOVEAL_SHARPNESS * (2.0 * q - 1.0);
  vec2 slope = FOVEAL_SHARPNESS / (asinh(FOVEAL_SHARPNESS) * sqrt(1.0 + u * u));
  return mat2(slope.x, 0.0, 0.0, slope.y);
}
