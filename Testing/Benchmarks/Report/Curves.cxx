// SPDX-License-Identifier: BSD-3-Clause
#include "Curves.h"

#include <algorithm>
#include <cmath>

namespace
{
// What counts as no error in a logarithm.
double Log(double value)
{
  return std::log(std::max(value, 1e-12));
}
}

double PowerLaw::At(double x) const
{
  return this->Factor * std::pow(x, this->Exponent);
}

std::optional<PowerLaw> Fit(const Curve& curve)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < curve.X.size(); ++i)
  {
    if (curve.X[i] > 0 && curve.Y[i] > 0)
    {
      const double a = std::log(curve.X[i]), b = std::log(curve.Y[i]);
      n += 1;
      x += a;
      y += b;
      xx += a * a;
      xy += a * b;
    }
  }
  const double spread = n * xx - x * x;
  if (n < 2 || !(spread > 1e-9))
  {
    return std::nullopt;
  }
  const double exponent = (n * xy - x * y) / spread;
  return PowerLaw{ std::exp((y - exponent * x) / n), exponent };
}

std::optional<double> Interpolate(
  const std::vector<double>& xs, const std::vector<double>& ys, double x)
{
  for (std::size_t i = 1; i < xs.size(); ++i)
  {
    if (xs[i - 1] <= x && x <= xs[i] && xs[i - 1] < xs[i])
    {
      const double along = (Log(x) - Log(xs[i - 1])) / (Log(xs[i]) - Log(xs[i - 1]));
      return std::exp(Log(ys[i - 1]) + along * (Log(ys[i]) - Log(ys[i - 1])));
    }
  }
  return std::nullopt;
}
