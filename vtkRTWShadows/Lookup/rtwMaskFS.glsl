// The shadow of a light on all that the view samples show: each visible pixel looks it up once, however often it is drawn over.
out vec4 mask;

void main()
{
  SampledPlane plane = rtwLoadPlane(ivec2(gl_FragCoord.xy));
  vec4 here = rtwOnLightPlane(0, plane.here);
  vec3 dx = rtwOnLightPlane(0, plane.right).xyz - here.xyz;
  vec3 dy = rtwOnLightPlane(0, plane.above).xyz - here.xyz;
  float visibility = rtwVisibility(0, here, dx, dy, plane.here);
  mask = vec4(rtwMaskValue(plane.seen ? visibility : RTW_NOT_LIT));
}
