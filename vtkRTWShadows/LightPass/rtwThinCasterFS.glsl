// A line or a point has no plane: its depth gradient is none.
layout(location = 0) out vec2 gradient;

void main()
{
  gradient = vec2(0.0);
}
