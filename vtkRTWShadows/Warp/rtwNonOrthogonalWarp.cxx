// SPDX-License-Identifier: BSD-3-Clause
#include "rtwNonOrthogonalWarp.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtw
{
namespace
{
constexpr int Passes = 3; // of smoothing

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
