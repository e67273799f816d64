// The distances from the eye between which a light's samples lie, for splits by ratios. A parallel view has no eye, and
// is split as a view from far away would be.
layout(std430, binding = 0) readonly buffer Range
{
  uint rtwRange[]; // for each light: nearest and farthest distance from where view coordinates begin
};
uniform float rtwBeyondEye; // distance from the eye to where view coordinates begin; below 0 where there is no eye
const float AS_FAR = 64.0;  // distance of a parallel view's substitute eye, in ranges

float rtwBeforeRange(int light)
{
  return rtwBeyondEye < 0.0 ? AS_FAR * uintBitsToFloat(rtwRange[2 * light + 1]) : rtwBeyondEye;
}

bool rtwHasRange(int light)
{
  return rtwRange[2 * light] <= rtwRange[2 * light + 1]; // positive floats
}

vec2 rtwRangeOf(int light)
{
  vec2 range = uintBitsToFloat(uvec2(rtwRange[2 * light], rtwRange[2 * light + 1])) + rtwBeforeRange(light);
  return vec2(max(range.x, 1e-6 * range.y), range.y);
}
