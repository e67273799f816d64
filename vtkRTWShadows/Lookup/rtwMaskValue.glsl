// A shadow as a byte: 0 to 127 in shadow, 129 to 255 lit, 128 neither, which is as good as lit.
float rtwMaskValue(float visibility)
{
  float value = visibility < 0.5 ? floor(visibility * 254.0) : 129.0 + floor((visibility - 0.5) * 252.0);
  return (visibility < 0.0 ? 128.0 : value) / 255.0;
}

float rtwMaskedVisibility(float value)
{
  float byte = floor(value * 255.0 + 0.5);
  return byte < 127.5 ? byte / 254.0 : byte > 128.5 ? 0.5 + (byte - 129.0) / 252.0 : 1.0;
}
