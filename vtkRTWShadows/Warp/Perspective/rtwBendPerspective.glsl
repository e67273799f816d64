// A perspective warp bends no edge, but a point half way along one isn't half way on the map. It turns over what
// reaches behind its centre of projection: what is nearer to that than half of n' is left out, which loses nothing, as
// it lies beside the map.
const float LEAST_DISTANCE = 0.5; // in units of n'

// The half plane in front of the centre of projection: points whose product of (q · w, w) with it is positive.
vec3 rtwFront(int layer)
{
  return vec3(0.0, rtwPerspective(layer).z, 1.0 - LEAST_DISTANCE);
}

// The bounds on the map of the part of a box on the light plane that is in front of the centre of projection: low,
// high; (2, 2, -1, -1) where there is no such part.
vec4 rtwBoundsOnMap(int layer, vec2 low, vec2 high)
{
  float k = rtwPerspective(layer).z;
  if (1.0 + k * high.y < LEAST_DISTANCE)
  {
    return vec4(2.0, 2.0, -1.0, -1.0);
  }
  low.y = 1.0 + k * low.y < LEAST_DISTANCE ? (LEAST_DISTANCE - 1.0) / k : low.y;
  vec2 a = rtwWarp(layer, low);
  vec2 b = rtwWarp(layer, high);
  float c = rtwWarp(layer, vec2(low.x, high.y)).x;
  float d = rtwWarp(layer, vec2(high.x, low.y)).x;
  return vec4(min(a.x, c), a.y, max(b.x, d), b.y);
}

bool rtwReachesBehind(int layer, float low)
{
  return 1.0 + rtwPerspective(layer).z * low < LEAST_DISTANCE;
}

// No straight line strays; but what reaches behind has no corners on the map.
vec2 rtwBends(int layer, vec2 low, vec2 high)
{
  return vec2(rtwReachesBehind(layer, low.y) ? 1e30 : 0.0);
}

// The share of its length that a point on a line moves along it at most, if z' changes by that ratio from one end to
// the other.
float rtwShareMoved(float ratio)
{
  float root = sqrt(ratio);
  return (root - 1.0) / (root + 1.0);
}

vec2 rtwShifts(int layer, vec2 low, vec2 high)
{
  float k = rtwPerspective(layer).z;
  float nearest = 1.0 + k * low.y;
  return nearest < LEAST_DISTANCE ? vec2(1e30) : rtwShareMoved(1.0 + k * (high.y - low.y) / nearest) * (high - low);
}

// How far a point moves along its line on the map, at most, in any box no larger than `piece` between the two corners.
vec2 rtwBendsOfPieces(int layer, vec2 low, vec2 high, vec2 piece)
{
  vec4 p = rtwPerspective(layer);
  float nearest = 1.0 + p.z * low.y;
  float aside = max(abs(low.x - p.w), abs(high.x - p.w));
  vec2 extent = vec2(piece.x + aside * p.z * piece.y / nearest, (1.0 + p.z) * piece.y / nearest) / nearest;
  extent.x /= p.y - p.x;
  return nearest < LEAST_DISTANCE ? vec2(1e30) : rtwShareMoved(1.0 + p.z * piece.y / nearest) * extent;
}
