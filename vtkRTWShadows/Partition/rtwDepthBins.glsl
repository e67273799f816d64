// Sorts samples into bins by depth: for each bin, the bounds of its samples on the light plane, and their demand, the
// sum of one over their footprint. Bins are even in ratio over the range that the light reaches.
layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 1) buffer Bins
{
  // For each bin: low s, low t, high s, high t, by rtwOrdered(); demand along s and t, low and high part each.
  uint rtwBins[];
};
uniform int rtwLight;
uniform vec4 rtwWholeBounds; // the light's own bounds: footprints are shares of their extent
const float LARGEST = 1048575.0;
shared uint rtwTile[BINS * BIN_SIZE];
vec2 rtwScale; // for the logarithm of depth: the least one, and one over its range

int rtwBinOf(float depth)
{
  float share = (log2(depth) - rtwScale.x) * rtwScale.y;
  return clamp(int(share * float(BINS)), 0, BINS - 1) * BIN_SIZE;
}

// The bin of the samples at hand: neighbours mostly fall to one bin, and are added together.
int rtwBinOfRun = -1;
vec4 rtwBoundsOfRun;
uvec2 rtwDemandOfRun;

void rtwEndRun()
{
  if (rtwBinOfRun < 0)
  {
    return;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    atomicMin(rtwTile[rtwBinOfRun + axis], rtwOrdered(rtwBoundsOfRun[axis]));
    atomicMax(rtwTile[rtwBinOfRun + 2 + axis], rtwOrdered(rtwBoundsOfRun[2 + axis]));
    // A tile's samples don't overflow.
    atomicAdd(rtwTile[rtwBinOfRun + 4 + axis], rtwDemandOfRun[axis]);
  }
}

void rtwVisit(LitSample s)
{
  int bin = rtwBinOf(max(rtwBeforeRange(rtwLight) - s.position.z, 1e-30));
  if (bin != rtwBinOfRun)
  {
    rtwEndRun();
    rtwBinOfRun = bin;
    rtwBoundsOfRun = s.onLight.xyxy;
    rtwDemandOfRun = uvec2(0u);
  }
  rtwBoundsOfRun = vec4(min(rtwBoundsOfRun.xy, s.onLight), max(rtwBoundsOfRun.zw, s.onLight));
  vec2 whole = rtwWholeBounds.zw - rtwWholeBounds.xy;
  rtwDemandOfRun += uvec2(clamp(whole / max(s.footprint, 1e-30), 1.0, LARGEST));
}

void rtwFlush(int light, int bin)
{
  int to = (light * BINS + bin) * BIN_STRIDE;
  int from = bin * BIN_SIZE;
  if (rtwTile[from] > rtwTile[from + 2])
  {
    return;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    atomicMin(rtwBins[to + axis], rtwTile[from + axis]);
    atomicMax(rtwBins[to + 2 + axis], rtwTile[from + 2 + axis]);
    uint low = rtwTile[from + 4 + axis];
    uint before = atomicAdd(rtwBins[to + 4 + 2 * axis], low);
    if (before > 0xffffffffu - low)
    {
      atomicAdd(rtwBins[to + 5 + 2 * axis], 1u);
    }
  }
}

void main()
{
  int me = int(gl_LocalInvocationIndex);
  for (int i = me; i < BINS * BIN_SIZE; i += 256)
  {
    rtwTile[i] = i % BIN_SIZE < 2 ? 0xffffffffu : 0u;
  }
  barrier();
  vec2 range = rtwRangeOf(rtwLight);
  rtwScale = vec2(log2(range.x), 1.0 / max(log2(range.y / range.x), 1e-6));
  rtwVisitTile();
  rtwEndRun();
  barrier();
  if (me < BINS)
  {
    rtwFlush(rtwLight, me);
  }
}
