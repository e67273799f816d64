// The plane that a sample lies on, by the first two coordinates of its normal, whose third is positive. As a float it is neither
// denormal nor not a number, which might not survive being copied.
float rtwPackNormal(vec3 normal)
{
  return uintBitsToFloat(packUnorm2x16(normal.xy * 0.17 + 0.28));
}

vec3 rtwUnpackNormal(float bits)
{
  vec2 xy = (unpackUnorm2x16(floatBitsToUint(bits)) - 0.28) / 0.17;
  return vec3(xy, sqrt(max(1.0 - dot(xy, xy), 0.0)));
}
