// SPDX-License-Identifier: BSD-3-Clause
#include "rtwAliasing.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rtw
{
namespace
{
// Texels for a pixel's step along the surface, measured over a fraction of it, since the density of
// a warped map changes.
glm::dvec2 Moves(const TexelFunction& texels, const glm::dvec3& at, const glm::dvec3& step)
{
  const double fraction = 1.0 / 64;
  return (texels(at + fraction * step) - texels(at - fraction * step)) / (2 * fraction);
}

double ErrorOf(const ViewSample& sample, const TexelFunction& texels)
{
  const glm::dvec2 right = Moves(texels, sample.Position, sample.ToRight);
  const glm::dvec2 above = Moves(texels, sample.Position, sample.ToAbove);
  double error = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    // A texel's width is 1 here.
    error = std::max(error, 1 / std::hypot(right[axis], above[axis]));
  }
  return std::isfinite(error) ? error : 0.0;
}
}

std::vector<double> AliasingErrors(
  const std::vector<ViewSample>& samples, const TexelFunction& texels)
{
  std::vector<double> errors(samples.size());
  std::transform(samples.begin(), samples.end(), errors.begin(),
    [&](const ViewSample& sample) { return ErrorOf(sample, texels); });
  return errors;
}

AliasingError Summarize(std::vector<double> errors)
{
  errors.erase(std::remove(errors.begin(), errors.end(), 0.0), errors.end());
  AliasingError summary;
  summary.Pixels = errors.size();
  if (!errors.empty())
  {
    const auto rank = errors.begin() + std::ptrdiff_t(0.95 * double(errors.size() - 1) + 0.5);
    std::nth_element(errors.begin(), rank, errors.end());
    summary.Percentile95 = *rank;
    summary.Maximum = *std::max_element(rank, errors.end());
    summary.Mean = std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
  }
  return summary;
}
}
