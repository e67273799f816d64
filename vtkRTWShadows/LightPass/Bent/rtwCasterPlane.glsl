// Depth and gradient of a triangle at a texel's centre, on the light plane, where it is a plane.
flat in vec3 anchor; // a corner: q and depth
flat in vec2 slope;  // of depth from there
flat in vec2 depthRange;
uniform int rtwLayer;

vec2 rtwCentreOfTexel()
{
  return rtwTexelCentre(rtwLayer, ivec2(gl_FragCoord.xy));
}

void rtwWrite(vec2 q)
{
  float depth = clamp(anchor.z + dot(slope, q - anchor.xy), depthRange.x, depthRange.y);
  gl_FragDepth = clamp(depth, 0.0, 1.0);
  gradient = rtwGradient(depth, slope);
}
