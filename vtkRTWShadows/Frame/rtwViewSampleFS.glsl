// Window-space depth is linear over a triangle, so that its screen derivatives give the plane.
layout(location = 0) out vec2 slope;

void main()
{
  slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
}
