// What a mapper's fragment is in the light pass (the occluder's depth gradient) and among the view samples.
// To be called by all fragments.
uniform vec2 rtwDepthToSample; // scale and offset

vec4 rtwGeometryOutput(float depth)
{
  if (rtwPhase == 2)
  {
    float a = depth * rtwDepthToSample.x + rtwDepthToSample.y;
    return vec4(a, dFdx(a), dFdy(a), 1.0);
  }
  vec2 centre = rtwTexelCentres(rtwLayer, ivec2(gl_FragCoord.xy)).xz;
  vec2 slope = vec2(dFdx(depth), dFdy(depth)) / vec2(dFdx(centre.x), dFdy(centre.y));
  return vec4(clamp(slope, -60000.0, 60000.0), 0.0, 1.0);
}
