// The radius of the window that lines are averaged in, from what strengths of smoothing cost: about that of the cheapest, but continuous.
layout(std430, binding = 2) readonly buffer Costs
{
  float rtwCosts[];
};
layout(std430, binding = 3) writeonly buffer Radius
{
  float rtwRadii[]; // first in lines, then its σ as a share of the focus
};
layout(local_size_x = 1) in;
uniform ivec2 rtwWarpSize;
uniform int rtwPasses;

void main()
{
  float least = rtwCosts[0];
  for (int k = 1; k < SMOOTHING_CANDIDATES; ++k)
  {
    least = min(least, rtwCosts[k]);
  }
  vec2 sum = vec2(0.0);
  for (int k = 0; k < SMOOTHING_CANDIDATES; ++k)
  {
    sum += exp(-(rtwCosts[k] / least - 1.0) / CHEAPEST_RANGE) * vec2(log(rtwSmoothingOf(k)), 1.0);
  }
  float smoothing = exp(sum.x / sum.y);
  float sigma = smoothing * float(rtwWarpSize.x);
  // Windows of 2 r + 1 lines have a variance of about ((2 r + 1)² - 1) / 12 each.
  rtwRadii[0] = 0.5 * (sqrt(1.0 + 12.0 * sigma * sigma / float(rtwPasses)) - 1.0);
  rtwRadii[1] = smoothing;
}
