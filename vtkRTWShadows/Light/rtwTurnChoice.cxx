// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwTurnChoice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rtw
{
namespace
{
constexpr int Steps = 8; // turns that a right angle is divided into
constexpr int AreaSteps = 32;
constexpr double MuchBetter = 0.9;
// CELLS of rtwTurnErrors.glsl.
constexpr int Cells = 256;
constexpr int Blur = 4;
constexpr double Sigma = 1.5;
constexpr double Floor = 0.01;
constexpr double Widest = 50;

glm::dvec2 Turned(const glm::dvec2& v, double turn)
{
  const double c = std::cos(turn), s = std::sin(turn);
  return { c * v.x + s * v.y, c * v.y - s * v.x };
}

int CellOf(double place, double low, double high)
{
  return std::clamp(static_cast<int>((place - low) / (high - low) * Cells), 0, Cells - 1);
}

std::vector<double> Candidates(double first, int steps, double last)
{
  std::vector<double> turns{ first };
  for (int i = 0; i < steps; ++i)
  {
    turns.push_back(glm::radians(90.0) * i / steps);
  }
  turns.push_back(last);
  return turns;
}

// The density of texels in each cell, in units of the mean.
std::vector<double> Spread(const std::vector<double>& asked)
{
  std::vector<double> density(Cells);
  for (int i = 0; i < Cells; ++i)
  {
    double weights = 0;
    for (int j = std::max(i - Blur, 0); j <= std::min(i + Blur, Cells - 1); ++j)
    {
      const double d = (j - i) / Sigma, weight = std::exp(-0.5 * d * d);
      density[i] += weight * std::sqrt(asked[j]);
      weights += weight;
    }
    density[i] /= weights;
  }
  const double mean = std::accumulate(density.begin(), density.end(), 0.0) / Cells;
  for (double& value : density)
  {
    value = mean > 0 ? std::max(value / mean, Floor) : 1.0;
  }
  return density;
}
}

std::vector<double> TurnCandidates(double inForce, double viewAligned)
{
  return Candidates(inForce, Steps, viewAligned);
}

std::vector<double> AreaCandidates(double inForce, double minimal)
{
  return Candidates(inForce, AreaSteps, minimal);
}

std::size_t BestTurn(const std::vector<float>& errors)
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < errors.size(); ++i)
  {
    const bool isMuchBetter = double(errors[i]) < MuchBetter * double(errors[0]);
    best = isMuchBetter && (best == 0 || errors[i] < errors[best]) ? i : best;
  }
  return best;
}

std::size_t LeastTurn(const std::vector<float>& areas)
{
  const std::size_t best = BestTurn(areas);
  return best == 0 && areas.size() > 1 && areas[1] < areas[0] ? 1 : best;
}

double Misplacement(const TurnSample& s, const glm::dvec2& off)
{
  const glm::dvec2 alongS(s.ToAbove.y, -s.ToRight.y), alongT(-s.ToAbove.x, s.ToRight.x);
  const bool known = s.Normal != glm::dvec2(0);
  const double moved = known
    ? off.x * std::abs(glm::dot(s.Normal, alongS)) + off.y * std::abs(glm::dot(s.Normal, alongT))
    : off.x * glm::length(alongS) + off.y * glm::length(alongT);
  const double area = std::abs(s.ToRight.x * s.ToAbove.y - s.ToRight.y * s.ToAbove.x);
  const double extents =
    off.x / std::hypot(s.ToRight.x, s.ToAbove.x) + off.y / std::hypot(s.ToRight.y, s.ToAbove.y);
  const double pixels = 0.5 * std::sqrt(moved / area * extents);
  return pixels < Widest ? pixels : Widest;
}

double TurnError(const std::vector<TurnSample>& samples, double turn, int texels, bool adapts)
{
  std::vector<TurnSample> turned = samples;
  glm::dvec2 low(INFINITY), high(-INFINITY);
  for (TurnSample& s : turned)
  {
    s.Place = Turned(s.Place, turn);
    s.ToRight = Turned(s.ToRight, turn);
    s.ToAbove = Turned(s.ToAbove, turn);
    low = glm::min(low, s.Place);
    high = glm::max(high, s.Place);
  }
  std::vector<double> density[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    std::vector<double> asked(Cells);
    for (const TurnSample& s : turned)
    {
      asked[CellOf(s.Place[axis], low[axis], high[axis])] +=
        (high[axis] - low[axis]) / std::hypot(s.ToRight[axis], s.ToAbove[axis]);
    }
    density[axis] = adapts ? Spread(asked) : std::vector<double>(Cells, 1.0);
  }
  double error = 0;
  for (const TurnSample& s : turned)
  {
    glm::dvec2 texel;
    for (int axis = 0; axis < 2; ++axis)
    {
      const int cell = CellOf(s.Place[axis], low[axis], high[axis]);
      texel[axis] = (high[axis] - low[axis]) / (texels * density[axis][cell]);
    }
    error += s.AtEdge ? Misplacement(s, texel) : 0.0;
  }
  return error;
}
}
