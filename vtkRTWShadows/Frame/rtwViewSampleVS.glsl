layout(location = 0) in vec3 point;
layout(location = 1) in mat4 toClip;

void main()
{
  gl_Position = toClip * vec4(point, 1.0);
}
