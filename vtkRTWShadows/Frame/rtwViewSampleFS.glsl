// One over the distance along the view axis is linear on the screen over a triangle, so that its derivatives give the plane; in
// a parallel view that is depth itself.
in float distanceAlongView;
layout(location = 0) out vec4 viewSample;
uniform int rtwParallel;
uniform float rtwReceiving; // 0 where nothing is received, but what is behind is hidden

void main()
{
  float a = rtwParallel != 0 ? gl_FragCoord.z : 1.0 / distanceAlongView;
  viewSample = vec4(a, dFdx(a), dFdy(a), rtwReceiving);
}
