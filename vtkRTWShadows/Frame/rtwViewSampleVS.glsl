layout(location = 0) in vec3 point;
layout(location = 1) in mat4 toClip;
out float distanceAlongView; // gl_FragCoord.w is too coarse on some drivers (Mesa's llvmpipe: some 1e-4)

void main()
{
  gl_Position = toClip * vec4(point, 1.0);
  distanceAlongView = gl_Position.w;
}
