vec4 rtwBoundsOnMap(int layer, vec2 low, vec2 high)
{
  return vec4(low, high);
}

vec2 rtwBends(int layer, vec2 low, vec2 high)
{
  return vec2(0.0);
}

vec2 rtwShifts(int layer, vec2 low, vec2 high)
{
  return vec2(0.0);
}

vec2 rtwBendsOfPieces(int layer, vec2 low, vec2 high, vec2 piece)
{
  return vec2(0.0);
}
