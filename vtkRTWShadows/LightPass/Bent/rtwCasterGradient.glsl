// The occluder's depth gradient in focused light-plane coordinates, for the dual depth test, as a 16-bit float holds it. A caster in
// front of the map's range is drawn at its near end, flat.
layout(location = 0) out vec2 gradient;

vec2 rtwGradient(float depth, vec2 slope)
{
  const float STEEPEST = 60000.0;
  return depth <= 0.0 ? vec2(0.0) : clamp(slope, -STEEPEST, STEEPEST);
}
