// A foveal warp: texels are dense in the middle of the focus and sparse at its ends, along s and t alike. The function
// rises everywhere, beyond the ends too, and so does its inverse.
const float FOVEAL_SHARPNESS = 3.0; // as rtw::FovealFunction has it

vec2 rtwWarp(int layer, vec2 q)
{
  if (layer >= rtwWarpedLayers)
  {
    return q;
  }
  return 0.5 + asinh(FOVEAL_SHARPNESS * (2.0 * q - 1.0)) / (2.0 * asinh(FOVEAL_SHARPNESS));
}

vec3 rtwWarpHomogeneous(int layer, vec2 q)
{
  return vec3(rtwWarp(layer, q), 1.0);
}

vec2 rtwTexelCentre(int layer, ivec2 texel)
{
  vec2 onMap = (vec2(texel) + 0.5) / vec2(rtwMapSize);
  if (layer >= rtwWarpedLayers)
  {
    return onMap;
  }
  return 0.5 + sinh(asinh(FOVEAL_SHARPNESS) * (2.0 * onMap - 1.0)) / (2.0 * FOVEAL_SHARPNESS);
}

TexelCentres rtwTexelCentres(int layer, ivec2 texel)
{
  vec2 here = rtwTexelCentre(layer, texel);
  vec2 next = rtwTexelCentre(layer, texel + 1);
  return TexelCentres(here, vec2(next.x, here.y), vec2(here.x, next.y), next);
}
