// One over the distance along the view axis is linear on the screen over a triangle, so that its derivatives give the plane; in
// a framed view so is depth, which has its bits where something is seen: 1 at the near end, 0 at the far.
in float distanceAlongView;
layout(location = 0) out vec4 viewSample;
uniform int rtwFramed;
uniform float rtwReceiving; // 0 where nothing is received, but what is behind is hidden

void main()
{
  float a = rtwFramed != 0 ? 1.0 - gl_FragCoord.z : 1.0 / distanceAlongView;
  viewSample = vec4(a, dFdx(a), dFdy(a), rtwReceiving);
}
