flat in vec3 edges[3];
flat in vec3 plane;
flat in vec2 depthRange;
flat in int bent;
layout(location = 0) out vec2 gradient;
uniform int rtwLayer;
const float STEEPEST = 60000.0;

void main()
{
  vec3 q = vec3(rtwTexelCentres(rtwLayer, ivec2(gl_FragCoord.xy)).xz, 1.0);
  // A point on a shared edge belongs to both triangles, so that nothing shines through between them.
  if (bent != 0 && (dot(edges[0], q) < 0.0 || dot(edges[1], q) < 0.0 || dot(edges[2], q) < 0.0))
  {
    discard;
  }
  float depth = clamp(dot(plane, q), depthRange.x, depthRange.y);
  gl_FragDepth = clamp(depth, 0.0, 1.0);
  gradient = depth <= 0.0 ? vec2(0.0) : clamp(plane.xy, -STEEPEST, STEEPEST);
}
