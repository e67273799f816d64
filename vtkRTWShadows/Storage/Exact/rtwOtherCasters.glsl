// How much light the map of casters that only VTK's mappers can draw lets through, where there are any: drivers that run both sides of
// a branch would look it up all the same.
float rtwOthers(SampledPlane plane)
{
#if RTW_HAS_OTHERS
  vec4 here = rtwOnLightPlane(0, plane.here);
  vec3 dx = rtwOnLightPlane(0, plane.right).xyz - here.xyz;
  vec3 dy = rtwOnLightPlane(0, plane.above).xyz - here.xyz;
  return rtwVisibility(0, here, dx, dy, plane.here);
#else
  return RTW_NOT_LIT;
#endif
}
