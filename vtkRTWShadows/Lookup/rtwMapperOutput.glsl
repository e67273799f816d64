// What a mapper's fragment is in the light pass (the occluder's depth gradient) and among the view samples (the depth's slope).
// To be called by all fragments.
vec4 rtwGeometryOutput(float depth)
{
  vec2 slope = vec2(dFdx(depth), dFdy(depth));
  if (rtwPhase == 1)
  {
    vec2 centre = rtwTexelCentres(rtwLayer, ivec2(gl_FragCoord.xy)).xz;
    slope /= vec2(dFdx(centre.x), dFdy(centre.y));
    slope = clamp(slope, -60000.0, 60000.0);
  }
  return vec4(slope, 0.0, 1.0);
}
