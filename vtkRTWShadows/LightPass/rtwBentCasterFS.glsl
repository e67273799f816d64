// Whether a texel's centre lies in the triangle, and its depth there, both on the light plane, where edges are straight.
flat in vec3 edges[3];   // signed distance from each at (q - anchor, 1)
flat in vec3 anchor;     // a corner: q and depth
flat in vec2 slope;      // of depth from there
flat in vec2 depthRange;
layout(location = 0) out vec2 gradient;
uniform int rtwLayer;
const float STEEPEST = 60000.0;
const float ROUNDING = 3e-7; // of the focus; a point on a shared edge belongs to both triangles, so that nothing leaks

void main()
{
  vec3 q = vec3(rtwTexelCentres(rtwLayer, ivec2(gl_FragCoord.xy)).xz - anchor.xy, 1.0);
  if (min(min(dot(edges[0], q), dot(edges[1], q)), dot(edges[2], q)) < -ROUNDING)
  {
    discard;
  }
  float depth = clamp(anchor.z + dot(slope, q.xy), depthRange.x, depthRange.y);
  gl_FragDepth = clamp(depth, 0.0, 1.0);
  gradient = depth <= 0.0 ? vec2(0.0) : clamp(slope, -STEEPEST, STEEPEST);
}
