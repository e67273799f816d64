layout(location = 0) in vec3 point;
layout(location = 1) in mat4 toFocused;
out vec4 focusedPoint; // q · w, depth · w, w

void main()
{
  focusedPoint = toFocused * vec4(point, 1.0);
}
