// An order that floats and unsigned integers share, for atomic minima and maxima.
uint rtwOrdered(float x)
{
  uint bits = floatBitsToUint(x);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float rtwUnordered(uint bits)
{
  return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}
