// Bounds are reduced where they are, on the light plane.
uniform int rtwLayer;

vec4 rtwPlaced(vec4 box)
{
  return box;
}
