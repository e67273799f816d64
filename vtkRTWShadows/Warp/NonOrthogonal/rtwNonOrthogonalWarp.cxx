// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/NonOrthogonal/rtwNonOrthogonalWarp.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace rtw
{
namespace
{
constexpr int Passes = 3; // windows that lines are averaged in, one after another

// The mean over a window of that radius, whose outermost lines count in part; none lie beyond the
// ends.
std::vector<double> WindowMean(const std::vector<double>& lines, double radius)
{
  const int count = static_cast<int>(lines.size()), whole = static_cast<int>(std::floor(radius));
  const auto at = [&](int line) { return line >= 0 && line < count ? lines[line] : 0.0; };
  std::vector<double> means;
  for (int line = 0; line < count; ++line)
  {
    double sum = (radius - whole) * (at(line - whole - 1) + at(line + whole + 1));
    for (int k = line - whole; k <= line + whole; ++k)
    {
      sum += at(k);
    }
    means.push_back(sum / (2 * radius + 1));
  }
  return means;
}

void SmoothAcross(std::vector<std::vector<double>>& lines, double sigma)
{
  const double radius = 0.5 * (std::sqrt(1 + 12 * sigma * sigma / Passes) - 1);
  for (std::size_t cell = 0; cell < lines.front().size(); ++cell)
  {
    std::vector<double> column;
    for (const std::vector<double>& line : lines)
    {
      column.push_back(line[cell]);
    }
    for (int pass = 0; pass < Passes; ++pass)
    {
      column = WindowMean(column, radius);
    }
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      lines[line][cell] = column[line];
    }
  }
}

using Grid = std::vector<std::vector<double>>;

Grid MakeCoarse(const Grid& lines)
{
  constexpr int side = SmoothingChoice::Cells;
  const int count = static_cast<int>(lines.size());
  Grid coarse(side, std::vector<double>(side));
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      for (int line = y * count / side; line < (y + 1) * count / side; ++line)
      {
        for (int cell = x * count / side; cell < (x + 1) * count / side; ++cell)
        {
          coarse[y][x] += lines[line][cell];
        }
      }
    }
  }
  return coarse;
}

/// Functions at the borders of cells, line by line.
Grid CoarseFunctions(const Grid& asked, double smoothing, bool root, double floor)
{
  constexpr int side = SmoothingChoice::Cells;
  std::vector<double> weights;
  for (int line = 0; line < side; ++line)
  {
    const double away = line / (smoothing * side);
    weights.push_back(std::exp(-0.5 * away * away));
  }
  Grid functions;
  for (int line = 0; line < side; ++line)
  {
    std::vector<double> values(side);
    for (int other = 0; other < side; ++other)
    {
      for (int cell = 0; cell < side; ++cell)
      {
        values[cell] += weights[std::abs(other - line)] * asked[other][cell];
      }
    }
    for (double& value : values)
    {
      value = root ? std::sqrt(value) : value;
    }
    const double all = std::accumulate(values.begin(), values.end(), 0.0);
    std::vector<double> function{ 0 };
    for (const double value : values)
    {
      function.push_back(function.back() + (all > 0 ? std::max(value, floor * all / side) : 1));
    }
    for (double& value : function)
    {
      value /= function.back();
    }
    functions.push_back(function);
  }
  return functions;
}

double CostOf(const Grid& asked, const Grid& functions, double bendCost)
{
  constexpr int side = SmoothingChoice::Cells;
  double cost = 0, all = 0;
  for (int line = 0; line < side; ++line)
  {
    const Grid::value_type& before = functions[std::max(line - 1, 0)];
    const Grid::value_type& here = functions[line];
    const Grid::value_type& after = functions[std::min(line + 1, side - 1)];
    const bool inner = line > 0 && line < side - 1;
    for (int cell = 0; cell < side; ++cell)
    {
      const auto middle = [cell](
                            const Grid::value_type& f) { return 0.5 * (f[cell] + f[cell + 1]); };
      const double down = middle(here) - middle(before), up = middle(after) - middle(here);
      const double shear =
        SmoothingChoice::Shear * (std::abs(down) + std::abs(up)) * side / (inner ? 2 : 1);
      const double bend = inner ? std::abs(up - down) * side * side : 0;
      const double density = (here[cell + 1] - here[cell]) * side;
      cost += asked[line][cell] / density * (std::sqrt(1 + shear * shear) + bendCost * bend);
      all += asked[line][cell];
    }
  }
  return all > 0 ? cost / all : 1;
}
}

double WarpingGrid::ChooseSmoothing(
  const std::vector<std::vector<double>>& lines, bool root, double floor, double bendCost)
{
  const Grid asked = MakeCoarse(lines);
  std::vector<double> costs;
  for (int k = 0; k < SmoothingChoice::Candidates; ++k)
  {
    const double smoothing = SmoothingChoice::Least * std::exp2(0.5 * k);
    costs.push_back(CostOf(asked, CoarseFunctions(asked, smoothing, root, floor), bendCost));
  }
  const double least = *std::min_element(costs.begin(), costs.end());
  double sum = 0, weights = 0;
  for (int k = 0; k < SmoothingChoice::Candidates; ++k)
  {
    const double weight = std::exp(-(costs[k] / least - 1) / SmoothingChoice::Range);
    sum += weight * 0.5 * k;
    weights += weight;
  }
  return SmoothingChoice::Least * std::exp2(sum / weights);
}

WarpingGrid WarpingGrid::FromImportance(
  std::vector<std::vector<double>> lines, double across, bool root, double sigma, double floor)
{
  SmoothAcross(lines, across);
  std::vector<WarpingFunction> functions;
  for (std::vector<double>& line : lines)
  {
    for (double& value : line)
    {
      value = root ? std::sqrt(value) : value;
    }
    functions.push_back(WarpingFunction::FromImportance(line, sigma, floor));
  }
  return FromFunctions(std::move(functions));
}

WarpingGrid WarpingGrid::FromFunctions(std::vector<WarpingFunction> lines)
{
  WarpingGrid grid;
  grid.Lines = std::move(lines);
  return grid;
}

WarpingGrid::Between WarpingGrid::LinesAt(double across) const
{
  const double count = static_cast<double>(this->Lines.size());
  const double line = std::clamp(across * count - 0.5, 0.0, count - 1);
  const double first = std::min(std::floor(line), count - 2);
  return { static_cast<int>(first), line - first };
}

double WarpingGrid::AtBorder(const Between& between, int border) const
{
  return (1 - between.Share) * this->Lines[between.Line].GetValues()[border] +
    between.Share * this->Lines[between.Line + 1].GetValues()[border];
}

double WarpingGrid::Forward(double along, double across) const
{
  if (along <= 0 || along >= 1)
  {
    return along;
  }
  const Between between = this->LinesAt(across);
  const int cells = this->Lines.front().GetCells();
  const int cell = std::min(static_cast<int>(along * cells), cells - 1);
  const double low = this->AtBorder(between, cell), high = this->AtBorder(between, cell + 1);
  return low + (along * cells - cell) * (high - low);
}

double WarpingGrid::Inverse(double value, double across) const
{
  if (value <= 0 || value >= 1)
  {
    return value;
  }
  const Between between = this->LinesAt(across);
  const int cells = this->Lines.front().GetCells();
  int low = 0, high = cells;
  while (high - low > 1)
  {
    const int middle = (low + high) / 2;
    (this->AtBorder(between, middle) <= value ? low : high) = middle;
  }
  const double from = this->AtBorder(between, low), to = this->AtBorder(between, low + 1);
  return (low + (value - from) / (to - from)) / cells;
}

glm::dvec2 NonOrthogonalWarp::Forward(const glm::dvec2& onLight) const
{
  const glm::dvec2 q = (onLight - this->Focus.Low) / (this->Focus.High - this->Focus.Low);
  const double s = this->Rows.Forward(q.x, q.y);
  return { s, this->Columns.Forward(q.y, s) };
}

glm::dvec2 NonOrthogonalWarp::Inverse(const glm::dvec2& onMap) const
{
  const double t = this->Columns.Inverse(onMap.y, onMap.x);
  const glm::dvec2 q(this->Rows.Inverse(onMap.x, t), t);
  return this->Focus.Low + q * (this->Focus.High - this->Focus.Low);
}
}
