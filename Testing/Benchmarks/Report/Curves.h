// SPDX-License-Identifier: BSD-3-Clause
// Points of lines, and what can be said of them.
#ifndef Curves_h
#define Curves_h

#include <optional>
#include <string>
#include <vector>

struct Curve
{
  std::string Name;
  std::vector<double> X, Y;
};

/// y = Factor * x ^ Exponent.
struct PowerLaw
{
  double Factor, Exponent;
  double At(double x) const;
};

/// Least squares of the logarithms. Nothing with less than two different x above zero.
std::optional<PowerLaw> Fit(const Curve& curve);

/// The value at `x`, between the nearest two points, linear in the logarithms; nothing beyond the
/// ends. The points are sorted by x.
std::optional<double> Interpolate(
  const std::vector<double>& xs, const std::vector<double>& ys, double x);

#endif
