// Splits what a light reaches by depth (Lloyd et al. 2006, equations 15 and 16; Zhang et al. 2006), into the warp table.
layout(local_size_x = 1) in;
layout(std430, binding = 1) buffer Table
{
  vec2 rtwTable[];
};
layout(std430, binding = 2) readonly buffer Splits
{
  float rtwSplits[]; // borders that samples decide, for each light, but for the range's ends
};
uniform int rtwParts; // layers by depth
uniform int rtwFaces; // layers of the same depths
uniform int rtwSplitBySamples;
uniform float rtwLambda; // from 0, even steps, to 1, even ratios
uniform float rtwBlend;  // width of the band in which two layers blend, as a share of the nearer one's interval
const float NOWHERE = 3e38;

float rtwSplit(vec2 range, int k)
{
  if (rtwSplitBySamples != 0)
  {
    int place = int(gl_WorkGroupID.x) * (rtwParts - 1) + clamp(k - 1, 0, rtwParts - 2);
    return k == 0 ? range.x : k == rtwParts ? range.y : rtwSplits[place];
  }
  float share = float(k) / float(rtwParts);
  float ratio = range.x * pow(range.y / range.x, share);
  return mix(mix(range.x, range.y, share), ratio, rtwLambda);
}

void main()
{
  int light = int(gl_WorkGroupID.x);
  bool isAny = rtwHasRange(light);
  vec2 range = rtwRangeOf(light);
  float before = rtwBeforeRange(light);
  for (int k = 0; k < rtwParts; ++k)
  {
    // The first and the last layer hold what isn't among the samples, too.
    float from = k == 0 ? 0.0 : isAny ? rtwSplit(range, k) - before : NOWHERE;
    float to = k == rtwParts - 1 || !isAny ? NOWHERE : rtwSplit(range, k + 1) - before;
    float blend = k == 0 ? 0.0 : from - rtwBlend * (from + before - rtwSplit(range, k - 1));
    for (int face = 0; face < rtwFaces; ++face)
    {
      int layer = (light * rtwParts + k) * rtwFaces + face;
      rtwTable[rtwWarpPlace(4 * layer, rtwWarpSize.x + 1)] = vec2(from, to);
      rtwTable[rtwWarpPlace(4 * layer + 1, rtwWarpSize.x + 1)] = vec2(isAny ? blend : from, 0.0);
    }
  }
}
