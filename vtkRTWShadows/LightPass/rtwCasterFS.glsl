// The occluder's depth gradient in focused light-plane coordinates, for the dual depth test. All three of q and depth are linear
// over the triangle, so their screen derivatives give its plane whatever the warp.
in vec3 onLight;
layout(location = 0) out vec2 gradient;
const float STEEPEST = 60000.0; // that a 16-bit float holds

void main()
{
  vec3 dx = dFdx(onLight);
  vec3 dy = dFdy(onLight);
  float area = dx.x * dy.y - dx.y * dy.x;
  vec2 g = vec2(dx.z * dy.y - dy.z * dx.y, dx.x * dy.z - dy.x * dx.z) / area;
  // A caster in front of the map's range is drawn at its near end, flat.
  bool flatten = onLight.z <= 0.0 || !(abs(g.x) < 1e30 && abs(g.y) < 1e30);
  gradient = flatten ? vec2(0.0) : clamp(g, -STEEPEST, STEEPEST);
}
