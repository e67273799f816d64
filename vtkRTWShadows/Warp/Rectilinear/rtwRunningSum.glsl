// A function from what its cells ask for, by a work group together: blurred, kept above the floor, summed up and normalized (Rosen 2012,
// section 4.2 and equation 1, which is that running sum; Milet et al. 2015, equations 2 to 5).
const int MOST_CELLS = 2048;
uniform float rtwSigma; // in cells
uniform float rtwFloor; // a share of the mean
uniform float rtwLeast; // share of the map that keeps sums strictly monotone
shared float rtwValues[MOST_CELLS + 1];
shared float rtwSums[MOST_CELLS + 1]; // what is asked for, then the sums
shared float rtwPartial[GROUP];

int me = int(gl_LocalInvocationIndex);

// The sum of `mine` over all invocations, in each of them.
float totalOf(float mine)
{
  rtwPartial[me] = mine;
  barrier();
  float all = 0.0;
  for (int i = 0; i < GROUP; ++i)
  {
    all += rtwPartial[i];
  }
  barrier();
  return all;
}

float total(int cells)
{
  float sum = 0.0;
  for (int i = me; i < cells; i += GROUP)
  {
    sum += rtwValues[i];
  }
  return totalOf(sum);
}

void blur(int cells)
{
  int radius = int(ceil(3.0 * rtwSigma));
  for (int i = me; i < cells; i += GROUP)
  {
    float sum = rtwSums[i];
    float weights = 1.0;
    for (int k = 1; k <= radius; ++k)
    {
      float d = float(k) / max(rtwSigma, 1e-3);
      float weight = exp(-0.5 * d * d);
      float before = i >= k ? weight : 0.0;
      float after = i + k < cells ? weight : 0.0;
      sum += before * rtwSums[max(i - k, 0)] + after * rtwSums[min(i + k, cells - 1)];
      weights += before + after;
    }
    rtwValues[i] = sum / weights;
  }
  barrier();
}

void raise(int cells)
{
  float all = total(cells);
  float least = max(rtwFloor / float(cells), rtwLeast) * all;
  for (int i = me; i < cells; i += GROUP)
  {
    rtwValues[i] = all > 0.0 ? max(rtwValues[i], least) : 1.0;
  }
  barrier();
}

// rtwSums[i] becomes the normalized sum of the values before i.
void sumUp(int cells)
{
  float all = total(cells);
  int each = (cells + GROUP - 1) / GROUP;
  float mine = 0.0;
  for (int i = me * each; i < min((me + 1) * each, cells); ++i)
  {
    mine += rtwValues[i];
  }
  rtwPartial[me] = mine;
  barrier();
  float before = 0.0;
  for (int i = 0; i < me; ++i)
  {
    before += rtwPartial[i];
  }
  for (int i = me * each; i < min((me + 1) * each, cells); ++i)
  {
    rtwSums[i] = before / all;
    before += rtwValues[i];
  }
  if (me == 0)
  {
    rtwSums[cells] = 1.0;
  }
  barrier();
}
