// Bounds are reduced in map coordinates: those of the part of a box on the light plane that is in the focus, which
// holds all samples.

vec4 rtwPlaced(vec4 box)
{
  vec4 focus = rtwFocus(rtwLayer);
  vec2 low = clamp(rtwFocused(focus, box.xy), 0.0, 1.0);
  vec2 high = clamp(rtwFocused(focus, box.zw), 0.0, 1.0);
  return rtwBoundsOnMap(rtwLayer, low, high);
}
