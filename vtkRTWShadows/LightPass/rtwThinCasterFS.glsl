// A line or a point has no plane: its depth gradient is none.
layout(location = 0) out vec2 gradient;
in float depth;

void main()
{
  gl_FragDepth = clamp(depth, 0.0, 1.0);
  gradient = vec2(0.0);
}
