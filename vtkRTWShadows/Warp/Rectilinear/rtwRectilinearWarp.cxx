// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace rtw
{
namespace
{
std::vector<double> Blur(const std::vector<double>& values, double sigma)
{
  const int count = static_cast<int>(values.size());
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> blurred(values.size());
  for (int i = 0; i < count; ++i)
  {
    double sum = 0, weights = 0;
    for (int j = std::max(0, i - radius); j <= std::min(count - 1, i + radius); ++j)
    {
      const double d = (j - i) / std::max(sigma, 1e-3);
      const double weight = std::exp(-0.5 * d * d);
      sum += weight * values[j];
      weights += weight;
    }
    blurred[i] = sum / weights;
  }
  return blurred;
}
}

int FramesToSettle(double blending, int resolution)
{
  return blending > 0
    ? static_cast<int>(std::ceil(std::log(0.25 / resolution) / std::log(blending)))
    : 1;
}

WarpingFunction WarpingFunction::FromImportance(std::vector<double> importance, double sigma,
  double floor, const std::vector<bool>& used, double reach)
{
  importance = Blur(importance, sigma);
  const double total = std::accumulate(importance.begin(), importance.end(), 0.0);
  const double least = std::max(floor / static_cast<double>(importance.size()), LeastShare) * total;
  for (double& value : importance)
  {
    value = total > 0 && std::isfinite(total) ? std::max(value, least) : 1.0;
  }
  return FromWidths(importance).Culled(used, sigma, reach);
}

// The function whose cells take shares of the map in proportion to these widths.
WarpingFunction WarpingFunction::FromWidths(const std::vector<double>& widths)
{
  WarpingFunction function;
  function.Values.assign(1, 0.0);
  for (const double width : widths)
  {
    function.Values.push_back(function.Values.back() + width);
  }
  const double sum = function.Values.back();
  for (double& value : function.Values)
  {
    value /= sum;
  }
  return function;
}

double WarpingFunction::WidthOf(int cell) const
{
  return this->Values[cell + 1] - this->Values[cell];
}

// Whether a cell is one of those in use, or near to one.
bool WarpingFunction::IsNeeded(
  int cell, const std::vector<bool>& used, int radius, double reach) const
{
  const int cells = this->GetCells(), parts = static_cast<int>(used.size());
  for (int part = 0; part < parts; ++part)
  {
    const int start = part * cells / parts, end = ((part + 1) * cells + parts - 1) / parts;
    const int away = std::max(cell - end, start - cell - 1);
    const double onMap = cell >= end ? this->Values[cell] - this->Values[end]
      : cell < start                 ? this->Values[start] - this->Values[cell + 1]
                                     : 0.0;
    if (used[part] && (away < radius || onMap < reach))
    {
      return true;
    }
  }
  return false;
}

WarpingFunction WarpingFunction::Culled(
  const std::vector<bool>& used, double sigma, double reach) const
{
  if (std::find(used.begin(), used.end(), true) == used.end())
  {
    return *this;
  }
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> widths;
  for (int cell = 0; cell < this->GetCells(); ++cell)
  {
    const bool needed = this->IsNeeded(cell, used, radius, reach);
    widths.push_back(needed ? std::max(this->WidthOf(cell), LeastShare) : 0.0);
  }
  const double least = LeastShare * std::accumulate(widths.begin(), widths.end(), 0.0);
  for (double& width : widths)
  {
    width = std::max(width, least);
  }
  return FromWidths(widths);
}

WarpingFunction WarpingFunction::BlendedWith(
  const WarpingFunction& last, double from, double to, double share) const
{
  const int cells = this->GetCells();
  const auto border = [&](int i) { return last.Forward(from + (to - from) * i / cells); };
  std::vector<double> widths;
  for (int cell = 0; cell < cells; ++cell)
  {
    const double was = (border(cell + 1) - border(cell)) / (border(cells) - border(0));
    widths.push_back(std::max((1 - share) * this->WidthOf(cell) + share * was, LeastShare));
  }
  return FromWidths(widths);
}

double WarpingFunction::ExcessOver(const WarpingFunction& best) const
{
  double error = 0;
  for (int cell = 0; cell < this->GetCells(); ++cell)
  {
    const double wanted = best.WidthOf(cell), given = this->WidthOf(cell);
    const bool isCulled = given < 2 * LeastShare && wanted >= 2 * LeastShare;
    error += isCulled ? std::numeric_limits<double>::infinity() : wanted * wanted / given;
  }
  return error - 1;
}

WarpingFunction WarpingFunction::SnappedTo(const WarpingFunction& last) const
{
  return last.ExcessOver(*this) <= SnappingMostExcess ? last : *this;
}

glm::dvec2 SnappedEnds(const glm::dvec2& needed, const glm::dvec2* last)
{
  const double extent = needed.y - needed.x;
  if (!last || extent < SnappingLeastShare * (last->y - last->x))
  {
    return { needed.x - SnappingMargin * extent, needed.y + SnappingMargin * extent };
  }
  return { needed.x < last->x ? needed.x - SnappingGrowth * extent : last->x,
    needed.y > last->y ? needed.y + SnappingGrowth * extent : last->y };
}

WarpingFunction WarpingFunction::FromValues(std::vector<double> values)
{
  WarpingFunction function;
  function.Values = std::move(values);
  return function;
}

double WarpingFunction::Forward(double x) const
{
  const int cells = this->GetCells();
  const double f = x * cells;
  const int cell = static_cast<int>(std::clamp(std::floor(f), 0.0, cells - 1.0));
  return this->Values[cell] + (f - cell) * (this->Values[cell + 1] - this->Values[cell]);
}

double WarpingFunction::Inverse(double y) const
{
  const auto above = std::upper_bound(this->Values.begin(), this->Values.end(), y);
  const int cell =
    std::clamp(static_cast<int>(above - this->Values.begin()) - 1, 0, this->GetCells() - 1);
  const double rise = this->Values[cell + 1] - this->Values[cell];
  return (cell + (y - this->Values[cell]) / rise) / this->GetCells();
}

double WarpingFunction::Slope(int cell) const
{
  return (this->Values[cell + 1] - this->Values[cell]) * this->GetCells();
}

double WarpingFunction::GreatestSlope() const
{
  double greatest = 0;
  for (int cell = 0; cell < this->GetCells(); ++cell)
  {
    greatest = std::max(greatest, this->Slope(cell));
  }
  return greatest;
}

// A function whose slope lies between a and b leaves its chord by (b - a) h / 4 at most.
double WarpingFunction::Bend(double low, double high) const
{
  const int cells = this->GetCells();
  const auto cellAt = [cells](double x) {
    return static_cast<int>(std::clamp(std::floor(x * cells), 0.0, cells - 1.0));
  };
  double least = this->Slope(cellAt(low)), greatest = least;
  for (int cell = cellAt(low); cell <= cellAt(high); ++cell)
  {
    least = std::min(least, this->Slope(cell));
    greatest = std::max(greatest, this->Slope(cell));
  }
  return 0.25 * (greatest - least) * (high - low);
}

glm::dvec2 RectilinearWarp::ToFocused(const glm::dvec2& onLight) const
{
  return (onLight - this->Focus.Low) / (this->Focus.High - this->Focus.Low);
}

glm::dvec2 RectilinearWarp::Forward(const glm::dvec2& onLight) const
{
  const glm::dvec2 q = this->ToFocused(onLight);
  return { this->S.Forward(q.x), this->T.Forward(q.y) };
}

glm::dvec2 RectilinearWarp::Inverse(const glm::dvec2& onMap) const
{
  const glm::dvec2 q(this->S.Inverse(onMap.x), this->T.Inverse(onMap.y));
  return this->Focus.Low + q * (this->Focus.High - this->Focus.Low);
}

glm::dvec2 RectilinearWarp::MaximumEffectiveResolution(int resolution, const Rectangle& whole) const
{
  const glm::dvec2 share = (whole.High - whole.Low) / (this->Focus.High - this->Focus.Low);
  return glm::dvec2(this->S.GreatestSlope(), this->T.GreatestSlope()) * share * double(resolution);
}
}
