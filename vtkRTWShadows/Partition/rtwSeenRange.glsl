// Between which distances a light's samples lie, for splits by ratios: from the eye. A parallel view has none, and splits as one would
// that is far away.
layout(std430, binding = 0) readonly buffer Range
{
  uint rtwRange[]; // a light: nearest, farthest, from where view coordinates begin
};
uniform float rtwBeyondEye; // of where they begin; below 0 where there is no eye
const float AS_FAR = 64.0;  // ranges

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
