flat in vec3 edges[3];
flat in vec3 anchor;
flat in vec2 slope;
flat in vec2 depthRange;
flat in int bent;
layout(location = 0) out vec2 gradient;
uniform int rtwLayer;
const float STEEPEST = 60000.0;
const float ROUNDING = 3e-7; // of the focus; a point on a shared edge belongs to both triangles, so that nothing leaks

void main()
{
  vec3 q = vec3(rtwTexelCentres(rtwLayer, ivec2(gl_FragCoord.xy)).xz - anchor.xy, 1.0);
  if (bent != 0 && (dot(edges[0], q) < -ROUNDING || dot(edges[1], q) < -ROUNDING || dot(edges[2], q) < -ROUNDING))
  {
    discard;
  }
  float depth = clamp(anchor.z + dot(slope, q.xy), depthRange.x, depthRange.y);
  gl_FragDepth = clamp(depth, 0.0, 1.0);
  gradient = depth <= 0.0 ? vec2(0.0) : clamp(slope, -STEEPEST, STEEPEST);
}
