// How far the foveal function strays from a straight line. A function leaves its chord over an interval of length h by no
// more than (b - a) h / 4, if its slope lies between a and b, and by no more than c h² / 8, if its curvature is c at most.
vec2 rtwFovealSlope(vec2 fromMiddle)
{
  vec2 u = 2.0 * FOVEAL_SHARPNESS * fromMiddle;
  return FOVEAL_SHARPNESS / (asinh(FOVEAL_SHARPNESS) * sqrt(1.0 + u * u));
}

vec2 rtwFovealLeastSlope(vec2 low, vec2 high)
{
  return rtwFovealSlope(max(abs(low - 0.5), abs(high - 0.5)));
}

vec2 rtwFovealBend(vec2 low, vec2 high, vec2 h)
{
  // The slope is greatest where the interval is nearest to the middle.
  vec2 steepest = rtwFovealSlope(max(max(low - 0.5, 0.5 - high), 0.0));
  float curvature = 0.7698 * FOVEAL_SHARPNESS * FOVEAL_SHARPNESS / asinh(FOVEAL_SHARPNESS);
  return min(0.25 * (steepest - rtwFovealLeastSlope(low, high)) * h, 0.125 * curvature * h * h);
}

// What a box on the light plane takes on the map: low, high.
vec4 rtwBoundsOnMap(int layer, vec2 low, vec2 high)
{
  return vec4(rtwWarp(layer, low), rtwWarp(layer, high));
}

// How far, along both axes of the map, a straight line in the box strays.
vec2 rtwBends(int layer, vec2 low, vec2 high)
{
  return rtwFovealBend(low, high, high - low);
}

// The same as lengths on the light plane.
vec2 rtwShifts(int layer, vec2 low, vec2 high)
{
  return rtwBends(layer, low, high) / rtwFovealLeastSlope(low, high);
}

// The most of any box no larger than `piece` between the two corners.
vec2 rtwBendsOfPieces(int layer, vec2 low, vec2 high, vec2 piece)
{
  return rtwFovealBend(low, high, min(piece, high - low));
}
