// Strengths of smoothing, σ as a share of the focus, that are tried out on a coarse grid.
float rtwSmoothingOf(int candidate)
{
  return LEAST_SMOOTHING * exp2(0.5 * float(candidate));
}
