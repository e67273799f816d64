// The error that a light's map would have with its plane turned otherwise, or the area that it would hold, predicted from listed view
// samples: the bounds of the turned samples, the density of texels that an adaptive warp gives each column and row, the square root of the demand there, and by how
// many pixels the shadow edges move that are off by a texel. A work group a turn.
layout(local_size_x = 256) in;
const int GROUP = 256;
const int CELLS = GROUP;
const int BLUR = 4;                // cells, three standard deviations and some
const float SIGMA = 1.5;
const float FLOOR = 0.01;          // share of the mean density
// The most that one sample asks for: the sum of 16384 samples in a cell has to fit in 32 bits.
const float MOST_ASKED = 262143.0;
const float WIDEST = 50.0;         // pixels that an edge can move by at most

layout(std430, binding = 0) readonly buffer Samples
{
  uint rtwCount;
  uint rtwEdgeCount;
  vec4 rtwListed[];
};
layout(std430, binding = 1) writeonly buffer Errors
{
  float rtwErrors[];
};
uniform vec2 rtwTurns[RTW_TURNS];    // cosine, sine
uniform vec4 rtwKept[RTW_TURNS];     // bounds of what the map has to hold besides samples: low, high
uniform vec4 rtwBounds[RTW_TURNS];   // bounds of the light: low, high
uniform int rtwSlots;
uniform int rtwFirstError;
uniform int rtwAdapts;     // 0: the map is not warped
uniform float rtwTexels;   // a side
uniform int rtwAreas;      // 1: areas are asked for, not errors
shared vec4 rtwPartial[GROUP];
shared uint rtwAsked[2 * CELLS];
shared float rtwDensity[2 * CELLS];

struct Turned
{
  vec2 place, dx, dy;
};

int turn = int(gl_WorkGroupID.x);
int me = int(gl_LocalInvocationIndex);
int count = int(min(rtwCount, uint(rtwSlots)));
int edges = int(min(rtwEdgeCount, uint(rtwSlots)));

vec2 rtwTurned(vec2 v)
{
  vec2 t = rtwTurns[turn];
  return vec2(t.x * v.x + t.y * v.y, t.x * v.y - t.y * v.x);
}

Turned rtwLoad(int place)
{
  vec4 a = rtwListed[place];
  return Turned(rtwTurned(a.xy), rtwTurned(a.zw), rtwTurned(rtwListed[place + 1].xy));
}

// The bounds around two bounds: low, high.
vec4 rtwUnion(vec4 a, vec4 b)
{
  return vec4(min(a.xy, b.xy), max(a.zw, b.zw));
}

vec4 rtwFindBounds()
{
  vec4 found = rtwKept[turn];
  for (int i = me; i < count; i += GROUP)
  {
    vec2 place = rtwTurned(rtwListed[2 * i].xy);
    found = rtwUnion(found, vec4(place, place));
  }
  rtwPartial[me] = found;
  barrier();
  for (int step = GROUP / 2; step > 0; step /= 2)
  {
    if (me < step)
    {
      rtwPartial[me] = rtwUnion(rtwPartial[me], rtwPartial[me + step]);
    }
    barrier();
  }
  vec4 all = rtwPartial[0];
  barrier();
  return vec4(max(all.xy, rtwBounds[turn].xy), min(all.zw, rtwBounds[turn].zw));
}

ivec2 rtwCell(vec4 bounds, vec2 place)
{
  return clamp(ivec2((place - bounds.xy) / (bounds.zw - bounds.xy) * float(CELLS)), 0, CELLS - 1);
}

// Adds up one over the extents of pixels in each cell.
void rtwAsk(vec4 bounds)
{
  for (int i = me; i < 2 * CELLS; i += GROUP)
  {
    rtwAsked[i] = 0u;
  }
  barrier();
  for (int i = me; i < count; i += GROUP)
  {
    Turned s = rtwLoad(2 * i);
    vec2 extent = vec2(length(vec2(s.dx.x, s.dy.x)), length(vec2(s.dx.y, s.dy.y)));
    uvec2 asked = uvec2(clamp((bounds.zw - bounds.xy) / extent, 1.0, MOST_ASKED) + 0.5);
    ivec2 cell = rtwCell(bounds, s.place);
    atomicAdd(rtwAsked[cell.x], asked.x);
    atomicAdd(rtwAsked[CELLS + cell.y], asked.y);
  }
  barrier();
}

// What is asked for around a cell, smoothed as a warping map is.
float rtwAskedAround(int i)
{
  int first = i < CELLS ? 0 : CELLS;
  float sum = 0.0;
  float weights = 0.0;
  for (int j = max(i - BLUR, first); j <= min(i + BLUR, first + CELLS - 1); ++j)
  {
    float d = float(j - i) / SIGMA;
    float weight = exp(-0.5 * d * d);
    sum += weight * sqrt(float(rtwAsked[j]));
    weights += weight;
  }
  return sum / weights;
}

// The sum of `mine` of both axes over all invocations, in every one.
vec2 rtwTotal(vec2 mine)
{
  rtwPartial[me] = vec4(mine, 0.0, 0.0);
  barrier();
  for (int step = GROUP / 2; step > 0; step /= 2)
  {
    if (me < step)
    {
      rtwPartial[me] += rtwPartial[me + step];
    }
    barrier();
  }
  vec2 all = rtwPartial[0].xy;
  barrier();
  return all;
}

// Makes densities of what is asked for, in units of the mean. The floor raises the mean itself by no more than its
// share.
void rtwSpread()
{
  float s = rtwAskedAround(me);
  float t = rtwAskedAround(CELLS + me);
  vec2 mean = rtwTotal(vec2(s, t)) / float(CELLS);
  bool even = rtwAdapts == 0 || mean.x <= 0.0 || mean.y <= 0.0;
  rtwDensity[me] = even ? 1.0 : max(s / mean.x, FLOOR);
  rtwDensity[CELLS + me] = even ? 1.0 : max(t / mean.y, FLOOR);
  barrier();
}

float rtwErrorOf(int edge, vec4 bounds)
{
  int place = 2 * rtwSlots + 3 * edge;
  Turned s = rtwLoad(place);
  ivec2 cell = rtwCell(bounds, s.place);
  vec2 texel = (bounds.zw - bounds.xy) / (rtwTexels * vec2(rtwDensity[cell.x], rtwDensity[CELLS + cell.y]));
  float moved = rtwMisplaced(s.dx, s.dy, rtwListed[place + 1].zw, texel);
  return rtwListed[place + 2].x * (moved < WIDEST ? moved : WIDEST);
}

void main()
{
  vec4 bounds = rtwFindBounds();
  if (rtwAreas != 0)
  {
    if (me == 0)
    {
      vec2 sides = max(bounds.zw - bounds.xy, 0.0);
      rtwErrors[rtwFirstError + turn] = sides.x * sides.y;
    }
    return;
  }
  rtwAsk(bounds);
  rtwSpread();
  float mine = 0.0;
  for (int i = me; i < edges; i += GROUP)
  {
    mine += rtwErrorOf(i, bounds);
  }
  float all = rtwTotal(vec2(mine, 0.0)).x;
  if (me == 0)
  {
    rtwErrors[rtwFirstError + turn] = all;
  }
}
