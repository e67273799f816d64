// What a mapper's fragment is in the light pass (the occluder's depth gradient) and among the view samples: z of p is its view coordinate,
// more precise than depth unless the view is framed, or p is 0 where it isn't known, as of what isn't lit; n is the normal of a surface that
// curves within the fragment, or 0.
// To be called by all fragments.
uniform vec2 rtwOwnDepthToSample; // scale and offset
uniform vec3 rtwRayStep;       // from pixel to pixel in view coordinates at distance 1; what a sample changes by with 1/distance, or with z
uniform vec3 rtwSeenFrom;      // a place in VTK's view coordinates, or in a parallel view a direction

vec4 rtwGeometryOutput(float depth, vec3 p, vec3 n)
{
  if (rtwPhase == 2)
  {
    bool perspective = cameraParallel == 0;
    float a = p.z < 0.0 && perspective && rtwFramed == 0 ? -1.0 / p.z : depth * rtwOwnDepthToSample.x + rtwOwnDepthToSample.y;
    vec2 slope = vec2(dFdx(a), dFdy(a));
    if (n != vec3(0.0))
    {
      // The slope is that of the tangent plane: a difference of two points on a sphere would be that of a chord.
      slope = n.xy * rtwRayStep.xy * rtwRayStep.z / (perspective ? dot(n, p - rtwSeenFrom) : dot(n, rtwSeenFrom));
    }
    return vec4(a, slope, p == vec3(0.0) ? 0.0 : float(rtwReceives));
  }
  vec2 centre = rtwTexelCentre(rtwLayer, ivec2(gl_FragCoord.xy));
  vec2 slope = vec2(dFdx(depth), dFdy(depth)) / vec2(dFdx(centre.x), dFdy(centre.y));
  return vec4(clamp(slope, -60000.0, 60000.0), 0.0, 1.0);
}
