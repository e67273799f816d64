// The bounds on the light plane of all view samples that the light can reach: the desired view (Rosen 2012, section 5.1; Milet
// et al. 2015, section 3.3), by parallel reduction.
//
// A sample of several pixels does not tell where the others lie. A first pass bounds the samples; where one might stand for more than all
// samples hold, a second looks at each of its pixels: guessing there would give away much of the map, as a pixel near the horizon is as
// wide as a landscape.
layout(local_size_x = 16, local_size_y = 16) in;

layout(std430, binding = 1) buffer Tiles
{
  vec4 rtwTiles[]; // what the pixels of a tile might hold
};
uniform int rtwClosely; // whether this is the second pass
shared vec4 rtwPartial[256];

const vec4 NOTHING = vec4(1e30, 1e30, -1e30, -1e30);

vec4 rtwSeen = NOTHING; // by this invocation
vec4 rtwMaybe = NOTHING;

// What the sample's pixels might hold: twice as far as a plane goes, which nears the horizon ever faster.
vec4 rtwHeldMaybe(LitSample s)
{
  return rtwPlaced(rtwAround(s.onLight, rtwFilterWidth / s.w + 2.0 * float(rtwStride - 1) * s.across));
}

void rtwVisit(LitSample s)
{
  rtwSeen = rtwUnited(rtwSeen, rtwPlaced(rtwAround(s.onLight, vec2(rtwFilterWidth / s.w))));
  rtwMaybe = rtwUnited(rtwMaybe, rtwHeldMaybe(s));
}

// Of all invocations, in the first's place.
void rtwReduce(vec4 mine)
{
  uint me = gl_LocalInvocationIndex;
  rtwPartial[me] = mine;
  barrier();
  for (uint step = 128u; step > 0u; step /= 2u)
  {
    if (me < step)
    {
      rtwPartial[me] = rtwUnited(rtwPartial[me], rtwPartial[me + step]);
    }
    barrier();
  }
}

// True where the samples' bounds hold all of that.
bool rtwIsSettled(vec4 maybe)
{
  int first = 8 * rtwLayer;
  return maybe.x > maybe.z ||
    (rtwOrdered(maybe.x) >= rtwBounds[first] && rtwOrdered(maybe.y) >= rtwBounds[first + 1] &&
      rtwOrdered(maybe.z) <= rtwBounds[first + 2] && rtwOrdered(maybe.w) <= rtwBounds[first + 3]);
}

void rtwLookClosely(ivec2 index)
{
  LitSample s = rtwLoadSample(index);
  if (!s.used || rtwIsSettled(rtwHeldMaybe(s)))
  {
    return;
  }
  SampledSquare square = rtwSquareOf(index, textureSize(rtwSamples, 0));
  for (int k = 0; k < square.extent.x * square.extent.y; ++k)
  {
    s = rtwLoadPixel(square.low + ivec2(k % square.extent.x, k / square.extent.x));
    if (s.used)
    {
      rtwVisit(s);
    }
  }
}

void main()
{
  uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (rtwClosely == 0)
  {
    rtwVisitTile();
    rtwReduce(rtwMaybe);
    if (gl_LocalInvocationIndex == 0u)
    {
      rtwTiles[tile] = rtwKept(rtwPartial[0]);
    }
    barrier();
  }
  else if (rtwIsSettled(rtwTiles[tile]))
  {
    return;
  }
  else
  {
    for (int i = 0; i < SAMPLES; ++i)
    {
      ivec2 index;
      if (rtwIsOfTile(i, index))
      {
        rtwLookClosely(index);
      }
    }
  }
  rtwReduce(rtwSeen);
  if (gl_LocalInvocationIndex == 0u && rtwPartial[0].x <= rtwPartial[0].z)
  {
    rtwAddBounds(rtwKept(rtwPartial[0]), rtwClosely);
  }
}
