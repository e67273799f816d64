// The functions of one axis, one a work group, from what each line's cells ask for: blurred, kept above the floor, summed up and normalized
// (Milet et al. 2015, equations 2 to 5; as rtwRunningSum.glsl, but four cells at a time, since there are many lines).
layout(local_size_x = GROUP) in;

layout(std430, binding = 1) writeonly buffer Grid
{
  vec2 rtwGrid[];
};
layout(std430, binding = 2) buffer Report
{
  uint rtwGreatest[]; // a layer, an axis: slope of all functions, as bits
};
layout(std430, binding = 4) writeonly buffer Totals
{
  float rtwTotals[]; // a layer, an axis, a line: what is asked for in all, as it was used
};
uniform samplerBuffer rtwSmoothed; // four cells each
uniform int rtwFirstSmoothed;
uniform int rtwLayer;
uniform int rtwAxis;
uniform int rtwIsUnderRoot;
uniform float rtwSigma; // in cells
uniform float rtwFloor; // a share of the mean
uniform float rtwLeast; // share of the map that keeps sums strictly monotone

const int MOST_CELLS = 2048;
shared float rtwValues[MOST_CELLS];
shared float rtwPartial[GROUP];

int cells = rtwWarpSize.x;
int quads = (cells + 3) / 4;
int line = int(gl_WorkGroupID.x);
int me = int(gl_LocalInvocationIndex);

vec4 rtwAskedFor(int quad)
{
  vec4 asked = texelFetch(rtwSmoothed, rtwFirstSmoothed + line * quads + clamp(quad, 0, quads - 1));
  return rtwIsUnderRoot != 0 ? sqrt(asked) : asked;
}

// The Gaussian's weights of cells that lie so many cells away.
vec4 rtwWeights(vec4 away)
{
  away /= max(rtwSigma, 1e-3);
  return exp(-0.5 * away * away);
}

// Four cells blurred by a Gaussian that ends at three times its σ, and at the ends of the line.
vec4 rtwBlurred(int quad)
{
  const vec4 OF_QUAD = vec4(0.0, 1.0, 2.0, 3.0);
  float radius = ceil(3.0 * rtwSigma);
  int reach = (int(radius) + 3) / 4;
  vec4 sum = vec4(0.0);
  vec4 weights = vec4(0.0);
  for (int k = -reach; k <= reach; ++k)
  {
    vec4 asked = rtwAskedFor(quad + k);
    vec4 at = float(4 * (quad + k)) + OF_QUAD;
    vec4 isCell = vec4(greaterThanEqual(at, vec4(0.0))) * vec4(lessThan(at, vec4(cells)));
    for (int j = 0; j < 4; ++j)
    {
      vec4 away = float(4 * k - j) + OF_QUAD;
      vec4 weight = rtwWeights(away) * vec4(lessThanEqual(abs(away), vec4(radius))) * isCell;
      sum[j] += dot(weight, asked);
      weights[j] += dot(weight, vec4(1.0));
    }
  }
  return sum / max(weights, 1e-30);
}

// The sum of `mine` over all invocations, and over those before this one.
vec2 rtwTotalOf(float mine)
{
  rtwPartial[me] = mine;
  barrier();
  vec2 all = vec2(0.0);
  for (int i = 0; i < GROUP; ++i)
  {
    float part = rtwPartial[i];
    all += vec2(part, i < me ? part : 0.0);
  }
  barrier();
  return all;
}

void main()
{
  float mine = 0.0;
  for (int quad = me; quad < quads; quad += GROUP)
  {
    vec4 blurred = rtwBlurred(quad);
    for (int j = 0; j < 4 && 4 * quad + j < cells; ++j)
    {
      rtwValues[4 * quad + j] = blurred[j];
      mine += blurred[j];
    }
  }
  float asked = rtwTotalOf(mine).x;
  float least = max(rtwFloor / float(cells), rtwLeast) * asked;
  int each = (cells + GROUP - 1) / GROUP;
  int first = min(me * each, cells);
  int end = min(first + each, cells);
  mine = 0.0;
  for (int i = first; i < end; ++i)
  {
    mine += asked > 0.0 ? max(rtwValues[i], least) : 1.0;
  }
  vec2 total = rtwTotalOf(mine);
  float steepest = 0.0;
  float before = total.y / total.x;
  int place = rtwGridPlace(rtwLayer, rtwAxis, line, 0);
  float sum = total.y;
  for (int i = first; i < end; ++i)
  {
    sum += asked > 0.0 ? max(rtwValues[i], least) : 1.0;
    float next = i == cells - 1 ? 1.0 : sum / total.x;
    rtwGrid[place + i] = vec2(before, next);
    steepest = max(steepest, next - before);
    before = next;
  }
  if (me == 0)
  {
    rtwTotals[(2 * rtwLayer + rtwAxis) * cells + line] = total.x;
  }
  atomicMax(rtwGreatest[2 * rtwLayer + rtwAxis], floatBitsToUint(steepest * float(cells)));
}
