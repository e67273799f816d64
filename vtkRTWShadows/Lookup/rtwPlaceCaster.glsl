// A mapper's vertex on its way into the shadow map: the light camera's clip coordinates are those of the light plane.
void rtwPlaceCaster()
{
  if (rtwPhase == 1 && gl_Position.w > 0.0)
  {
    vec2 q = rtwFocused(rtwFocus(rtwLayer), gl_Position.xy / gl_Position.w);
    gl_Position.xy = (2.0 * rtwWarp(rtwLayer, q) - 1.0) * gl_Position.w;
  }
}
