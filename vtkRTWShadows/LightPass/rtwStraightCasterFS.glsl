// The occluder's depth gradient in focused light-plane coordinates, for the dual depth test.
flat in vec2 slope;
layout(location = 0) out vec2 gradient;

void main()
{
  // A caster in front of the map's range is drawn at its near end, flat.
  gradient = gl_FragCoord.z <= 0.0 ? vec2(0.0) : slope;
}
