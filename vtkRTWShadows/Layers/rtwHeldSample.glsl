// What a sample says of the bounds of what the camera sees.
// A sample that stands for several pixels does not tell where the other pixels' surfaces lie. A first pass bounds the
// samples; where one might stand for more than all samples hold, a second looks at each of its pixels: guessing there
// would give away much of the map, as a pixel near the horizon is as wide as a landscape.

vec4 rtwHeld(LitSample s)
{
  return rtwPlaced(rtwAround(s.onLight, vec2(rtwFilterWidth / s.w)));
}

// The bounds of what the sample's pixels might hold: twice as far as its plane goes, since a plane nears the horizon
// ever faster.
vec4 rtwHeldMaybe(LitSample s)
{
  return rtwPlaced(rtwAround(s.onLight, rtwFilterWidth / s.w + 2.0 * float(rtwStride - 1) * s.across));
}
