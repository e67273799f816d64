// What a mapper's fragment is in the light pass (the occluder's depth gradient) and among the view samples: z is its view coordinate,
// more precise than depth, or 0 where it isn't known. To be called by all fragments.
uniform vec2 rtwDepthToSample; // scale and offset

vec4 rtwGeometryOutput(float depth, float z)
{
  if (rtwPhase == 2)
  {
    float a = z < 0.0 && cameraParallel == 0 ? -1.0 / z : depth * rtwDepthToSample.x + rtwDepthToSample.y;
    return vec4(a, dFdx(a), dFdy(a), float(rtwReceives));
  }
  vec2 centre = rtwTexelCentres(rtwLayer, ivec2(gl_FragCoord.xy)).xz;
  vec2 slope = vec2(dFdx(depth), dFdy(depth)) / vec2(dFdx(centre.x), dFdy(centre.y));
  return vec4(clamp(slope, -60000.0, 60000.0), 0.0, 1.0);
}
