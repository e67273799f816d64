// How much light the map of casters that only VTK's mappers can draw lets through.
float rtwOthers(SampledPlane plane)
{
  vec4 here = rtwOnLightPlane(0, plane.here);
  vec3 dx = rtwOnLightPlane(0, plane.right).xyz - here.xyz;
  vec3 dy = rtwOnLightPlane(0, plane.above).xyz - here.xyz;
  return rtwVisibility(0, here, dx, dy, plane.here);
}
