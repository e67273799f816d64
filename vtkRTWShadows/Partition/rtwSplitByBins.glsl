// Splits what a light reaches so that the error which fitted layers are predicted to have is least: summed over layers and axes, the extent
// on the light plane times the demand. By dynamic programming: the best layers up to a bin begin with the best up to where the last begins.
layout(local_size_x = BINS) in;
layout(std430, binding = 1) readonly buffer Bins
{
  uint rtwBins[];
};
layout(std430, binding = 2) writeonly buffer Splits
{
  float rtwSplits[]; // for each light: the borders of its layers but for the range's ends
};
uniform int rtwParts;
shared vec4 rtwBounds[BINS];
shared vec2 rtwDemand[BINS];
shared float rtwLeast[2][BINS + 1]; // least error of all layers before a bin
shared int rtwBegin[8][BINS + 1];   // where a layer that ends before a bin begins
const float NEVER = 1e30;

void rtwLoad(int light, int bin)
{
  int from = (light * BINS + bin) * BIN_STRIDE;
  bool any = rtwBins[from] <= rtwBins[from + 2];
  rtwBounds[bin] = any ? vec4(rtwUnordered(rtwBins[from]), rtwUnordered(rtwBins[from + 1]), rtwUnordered(rtwBins[from + 2]),
                           rtwUnordered(rtwBins[from + 3]))
                       : vec4(NEVER, NEVER, -NEVER, -NEVER);
  vec2 low = vec2(float(rtwBins[from + 4]), float(rtwBins[from + 6]));
  vec2 high = vec2(float(rtwBins[from + 5]), float(rtwBins[from + 7]));
  rtwDemand[bin] = low + high * 4294967296.0;
}

void rtwExtend(int layer, int end)
{
  float least = rtwLeast[(layer + 1) % 2][end];
  int begin = end;
  vec4 bounds = vec4(NEVER, NEVER, -NEVER, -NEVER);
  vec2 demand = vec2(0.0);
  for (int first = end - 1; first >= 0; --first)
  {
    bounds = vec4(min(bounds.xy, rtwBounds[first].xy), max(bounds.zw, rtwBounds[first].zw));
    demand += rtwDemand[first];
    float error = rtwLeast[(layer + 1) % 2][first] + dot(max(bounds.zw - bounds.xy, 0.0), demand);
    if (error < least)
    {
      least = error;
      begin = first;
    }
  }
  rtwLeast[layer % 2][end] = least;
  rtwBegin[layer - 1][end] = begin;
}

// Writes the borders; a layer that has nothing lies at the range's ends.
void rtwWrite(int light)
{
  vec2 range = rtwRangeOf(light);
  int end = BINS;
  for (int layer = rtwParts; layer > 1; --layer)
  {
    end = rtwBegin[layer - 1][end];
    rtwSplits[light * (rtwParts - 1) + layer - 2] = range.x * pow(range.y / range.x, float(end) / float(BINS));
  }
}

void main()
{
  int light = int(gl_WorkGroupID.x);
  int me = int(gl_LocalInvocationIndex);
  rtwLoad(light, me);
  rtwLeast[0][me + 1] = NEVER;
  rtwLeast[0][0] = 0.0;
  rtwLeast[1][0] = 0.0;
  barrier();
  for (int layer = 1; layer <= rtwParts; ++layer)
  {
    rtwExtend(layer, me + 1);
    barrier();
  }
  if (me == 0)
  {
    rtwWrite(light);
  }
}
