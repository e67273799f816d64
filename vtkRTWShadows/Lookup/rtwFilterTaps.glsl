// Percentage-closer filtering (Reeves et al. 1987): the mean of the decisions of texels around a receiver, weighted by a
// Gaussian that is let down to nothing at its reach. On a warped map (Rosen 2012, section 6.2) there are two planes to do that
// in: the map, where its width is so many texels (PCF, RTW_FILTER 2), and the light plane, where its width is the same everywhere
// (SOFT, 3); there each tap is warped by itself.
//
// Taps lie on a lattice that stays where it is while receivers pass over it, so that the mean is as smooth as the weights. Rows and
// columns are displaced against each other: no edge, however it runs, meets many taps at once.
// SOFT: a point that the lattice is fixed to, and its spacing, on the light plane; w: the radius, for PCF in texels
uniform vec4 rtwTaps[RTW_LIGHTS];
uniform int rtwFilterJitter;      // whether each pixel displaces the lattice by its own vector

const float RTW_LATTICE_PERIOD = 5.0;
const float RTW_TAPS_A_RADIUS = 3.0; // lattice steps from the middle of the kernel to its rim, at most

struct rtwKernel
{
  vec2 at;       // the receiver, in the plane of the filter
  vec2 reach;    // beyond which nothing counts
  vec2 spacing; // from a lattice point to the next
  vec2 origin; // a point of the lattice
  float falloff; // 1 a Gaussian of half the reach, 0 a tent
};

// Interleaved gradient noise (Jimenez 2014).
float rtwNoise(vec2 pixel)
{
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
}

#if RTW_FILTER == 2
rtwKernel rtwMakeKernel(int light, int layer, vec4 focus, rtwReceiver r, float w)
{
  float reach = rtwTaps[light].w + 1.0; // the radius 0 has the reach of BILINEAR, one texel
  vec2 at = rtwWarp(layer, r.q.xy) * vec2(rtwMapSize);
  float spacing = ceil(reach / RTW_TAPS_A_RADIUS - 1e-3);
  return rtwKernel(at, vec2(reach), vec2(spacing), vec2(0.0), min(rtwTaps[light].w, 1.0));
}

// Taps are texels' centres.
vec2 rtwOnLattice(vec2 place, rtwKernel k)
{
  return (floor(place * k.spacing) + 0.5) / k.spacing;
}

vec2 rtwTexelOf(int layer, vec2 tap)
{
  return tap;
}
#else
rtwKernel rtwMakeKernel(int light, int layer, vec4 focus, rtwReceiver r, float w)
{
  vec4 taps = rtwTaps[light];
  ivec2 texel = ivec2(rtwWarp(layer, r.q.xy) * vec2(rtwMapSize));
  TexelCentres c = rtwTexelCentres(layer, clamp(texel, ivec2(0), rtwMapSize - 1));
  // A reach of less than a texel would show the texels.
  vec2 reach = max(vec2(taps.w / w), (abs(c.right - c.here) + abs(c.above - c.here)) / focus.yw);
  // The spacing grows in few steps, because a lattice that differs from pixel to pixel is noise.
  vec2 steps = ceil(2.0 * log2(reach / (RTW_TAPS_A_RADIUS * taps.z)) - 0.01);
  vec2 spacing = taps.z * exp2(0.5 * steps);
  return rtwKernel(
    r.q.xy, reach * focus.yw, spacing * focus.yw, (taps.xy - focus.xz) * focus.yw, 1.0);
}

vec2 rtwOnLattice(vec2 place, rtwKernel k)
{
  return place;
}

vec2 rtwTexelOf(int layer, vec2 tap)
{
  return rtwWarp(layer, tap) * vec2(rtwMapSize);
}
#endif

// Where a tap lies in its cell of the lattice.
vec2 rtwPlaceInCell(ivec2 cell, rtwKernel k)
{
  vec2 turn = 2.0 * vec2(cell.yx);
  turn -= RTW_LATTICE_PERIOD * floor((turn + 0.5) / RTW_LATTICE_PERIOD);
  return rtwOnLattice((turn + 0.5) / RTW_LATTICE_PERIOD, k);
}

float rtwWeight(vec2 away, float falloff)
{
  vec2 tent = max(1.0 - abs(away), 0.0);
  return tent.x * tent.y * exp(-2.0 * falloff * dot(away, away));
}

// The weighted mean of the decisions at all taps: 1 lit, 0 in shadow.
float rtwFilteredByTaps(int layer, rtwReceiver r, rtwKernel k)
{
  vec2 shift = rtwFilterJitter == 0
    ? vec2(0.0)
    : RTW_LATTICE_PERIOD * vec2(rtwNoise(gl_FragCoord.xy), rtwNoise(gl_FragCoord.yx + 101.0));
  vec2 at = (k.at - k.origin) / k.spacing + rtwOnLattice(shift, k) - rtwOnLattice(vec2(0.0), k);
  vec2 reach = k.reach / k.spacing;
  vec2 cell = floor(at);
  vec2 within = at - cell;
  // The least and the most that rtwPlaceInCell() gives.
  vec2 low = rtwOnLattice(vec2(0.5 / RTW_LATTICE_PERIOD), k);
  // The loop is bounded to three steps either way, also where the reach is infinite or not a number.
  ivec2 first = max(ivec2(ceil(within - reach - 1.0 + low)), -3);
  ivec2 last = min(ivec2(floor(within + reach - low)), 3);
  vec2 sum = vec2(0.0);
  for (int j = first.y; j <= last.y; ++j)
  {
    for (int i = first.x; i <= last.x; ++i)
    {
      vec2 away = vec2(i, j) + rtwPlaceInCell(ivec2(cell) + ivec2(i, j), k) - within;
      float weight = rtwWeight(away / reach, k.falloff);
      if (weight == 0.0)
      {
        continue;
      }
      ivec2 texel = ivec2(floor(rtwTexelOf(layer, k.at + away * k.spacing)));
      ivec2 held = clamp(texel, ivec2(0), rtwMapSize - 1);
      // Beyond the map nothing is known.
      weight = held == texel ? weight : 0.0;
      vec2 centre = rtwTexelCentre(layer, held);
      float dark = rtwOccluded(layer, held, centre, r, rtwSlope(layer, held), 0.0);
      sum += weight * vec2(1.0 - dark, 1.0);
    }
  }
  return sum.y > 0.0 ? sum.x / sum.y : rtwBilinear(layer, r);
}
