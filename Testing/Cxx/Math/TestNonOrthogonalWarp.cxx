// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/NonOrthogonal/rtwNonOrthogonalWarp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using rtw::NonOrthogonalWarp;
using rtw::WarpingGrid;
using Grid = std::vector<std::vector<double>>;

constexpr int Cells = 48;

// Over six decades, and none at all in a third of the cells.
Grid RandomImportance(std::mt19937& random)
{
  std::uniform_real_distribution<double> decade(-3, 3), share(0, 1);
  Grid lines(Cells, std::vector<double>(Cells));
  for (std::vector<double>& line : lines)
  {
    for (double& value : line)
    {
      value = share(random) < 1.0 / 3 ? 0 : std::pow(10, decade(random));
    }
  }
  return lines;
}

WarpingGrid RandomGrid(std::mt19937& random)
{
  return WarpingGrid::FromImportance(
    RandomImportance(random), random() % 2 ? 0 : 2, random() % 2 != 0, 2, 0.01);
}

NonOrthogonalWarp RandomWarp(std::mt19937& random)
{
  return { { { -3, 2 }, { 5, 9 } }, RandomGrid(random), RandomGrid(random) };
}

TEST(WarpingGrid, IsTheIdentityUnlessToldOtherwise)
{
  const WarpingGrid grid;
  for (const double x : { -0.5, 0.0, 0.25, 1.0, 1.5 })
  {
    EXPECT_DOUBLE_EQ(grid.Forward(x, 0.3), x);
    EXPECT_DOUBLE_EQ(grid.Inverse(x, 0.8), x);
  }
}

TEST(WarpingGrid, RisesAndIsContinuous)
{
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round)
  {
    const WarpingGrid grid = RandomGrid(random);
    constexpr double tiny = 1e-9;
    for (int j = 0; j <= 4 * Cells; ++j)
    {
      const double across = j / (4.0 * Cells); // borders and middles of lines are among them
      double last = -0.1;
      for (int i = 0; i <= 2 * Cells; ++i)
      {
        const double along = i / (2.0 * Cells), value = grid.Forward(along, across);
        ASSERT_GT(value, last) << along << ", " << across;
        last = value;
        ASSERT_NEAR(grid.Forward(along, across + tiny), value, 100 * tiny * Cells);
        ASSERT_NEAR(grid.Forward(along + tiny, across), value, 100 * tiny * Cells);
      }
      ASSERT_DOUBLE_EQ(last, 1);
    }
  }
}

TEST(WarpingGrid, AveragesLinesMoreWhereItIsSmoother)
{
  std::mt19937 random(2);
  const Grid importance = RandomImportance(random);
  double before = 1;
  for (const double sigma : { 0.5, 2.0, 8.0, 32.0 })
  {
    const auto grid = WarpingGrid::FromImportance(importance, sigma, false, 2, 0.01);
    double most = 0;
    for (int line = 0; line + 1 < Cells; ++line)
    {
      for (int border = 0; border <= Cells; ++border)
      {
        most = std::max(most,
          std::abs(grid.GetLines()[line].GetValues()[border] -
            grid.GetLines()[line + 1].GetValues()[border]));
      }
    }
    EXPECT_LT(most, before) << sigma;
    before = most;
  }
  EXPECT_LT(before, 0.01);
}

TEST(NonOrthogonalWarp, InverseUndoesForward)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-0.1, 1.1);
  for (int round = 0; round < 20; ++round)
  {
    const NonOrthogonalWarp warp = RandomWarp(random);
    for (int i = 0; i < 500; ++i)
    {
      const glm::dvec2 q(anywhere(random), anywhere(random));
      const glm::dvec2 onLight = warp.Focus.Low + q * (warp.Focus.High - warp.Focus.Low);
      const glm::dvec2 back = warp.Inverse(warp.Forward(onLight));
      ASSERT_NEAR(back.x, onLight.x, 1e-9);
      ASSERT_NEAR(back.y, onLight.y, 1e-9);
    }
  }
}

// What the paper is for: each texel gets as many samples.
TEST(NonOrthogonalWarp, SpreadsCountedSamplesEvenly)
{
  std::mt19937 random(4);
  std::normal_distribution<double> along(0.3, 0.05);
  std::vector<glm::dvec2> samples;
  while (samples.size() < 100000)
  {
    // A curved band, which no rectilinear warp straightens.
    const double t = std::uniform_real_distribution<double>(0, 1)(random);
    const glm::dvec2 q(along(random) + 0.5 * t * t, t);
    if (q.x >= 0 && q.x < 1)
    {
      samples.push_back(q);
    }
  }
  const auto cell = [](double x) { return std::min(static_cast<int>(x * Cells), Cells - 1); };
  NonOrthogonalWarp warp{ { { 0, 0 }, { 1, 1 } }, {}, {} };
  for (int axis = 0; axis < 2; ++axis)
  {
    Grid counts(Cells, std::vector<double>(Cells));
    for (const glm::dvec2& q : samples)
    {
      const double across = axis == 0 ? q.y : warp.Rows.Forward(q.x, q.y);
      counts[cell(across)][cell(q[axis])] += 1;
    }
    (axis == 0 ? warp.Rows : warp.Columns) =
      WarpingGrid::FromImportance(counts, 0.5, false, 0.5, 0.01);
  }
  constexpr int Texels = 12;
  std::vector<int> lists(Texels * Texels), plain(Texels * Texels);
  for (const glm::dvec2& q : samples)
  {
    const glm::dvec2 m = warp.Forward(q);
    ++lists[std::min(int(m.y * Texels), Texels - 1) * Texels +
      std::min(int(m.x * Texels), Texels - 1)];
    ++plain[int(q.y * Texels) * Texels + int(q.x * Texels)];
  }
  const double mean = double(samples.size()) / (Texels * Texels);
  EXPECT_LT(*std::max_element(lists.begin(), lists.end()), 1.5 * mean);
  EXPECT_GT(*std::min_element(lists.begin(), lists.end()), 0.6 * mean);
  EXPECT_GT(*std::max_element(plain.begin(), plain.end()), 4 * mean);
}

using rtw::SmoothingChoice;

// Spots here and there, each on some lines only, beside a little everywhere.
Grid RandomSpots(std::mt19937& random)
{
  std::uniform_real_distribution<double> share(0, 1);
  Grid lines(100, std::vector<double>(100, 1e-3));
  for (int spot = 0; spot < 6; ++spot)
  {
    const double x = 100 * share(random), y = 100 * share(random), wide = 3 + 20 * share(random);
    for (int line = 0; line < 100; ++line)
    {
      for (int cell = 0; cell < 100; ++cell)
      {
        const double away = std::hypot(cell - x, line - y) / wide;
        lines[line][cell] += std::exp(-away * away);
      }
    }
  }
  return lines;
}

TEST(ChosenSmoothing, IsMoreTheLessMayStray)
{
  std::mt19937 random(3);
  for (int round = 0; round < 10; ++round)
  {
    const Grid lines = RandomSpots(random);
    double before = 0;
    for (const double bendCost : { 0.0, 0.003, 0.03, 0.3, 3.0 })
    {
      const double smoothing = WarpingGrid::ChooseSmoothing(lines, true, 0.01, bendCost);
      EXPECT_GE(smoothing, before);
      before = smoothing;
    }
    EXPECT_GT(before, 2 * WarpingGrid::ChooseSmoothing(lines, true, 0.01, 0));
  }
}

TEST(ChosenSmoothing, IsTheSameForMoreOfTheSame)
{
  std::mt19937 random(4);
  Grid lines = RandomSpots(random);
  const double smoothing = WarpingGrid::ChooseSmoothing(lines, true, 0.01, 0);
  for (std::vector<double>& line : lines)
  {
    for (double& value : line)
    {
      value *= 1000;
    }
  }
  EXPECT_NEAR(WarpingGrid::ChooseSmoothing(lines, true, 0.01, 0), smoothing, 1e-9);
}

TEST(ChosenSmoothing, StaysInItsRange)
{
  std::mt19937 random(5);
  const double most = SmoothingChoice::Least * std::exp2(0.5 * (SmoothingChoice::Candidates - 1));
  std::vector<Grid> all{ Grid(100, std::vector<double>(100)), Grid(64, std::vector<double>(64, 1)),
    Grid(64, std::vector<double>(64)) };
  all.back()[10][20] = 1; // a single cell
  for (int round = 0; round < 10; ++round)
  {
    all.push_back(RandomImportance(random));
  }
  for (const Grid& lines : all)
  {
    for (const double bendCost : { 0.0, 10.0 })
    {
      const double smoothing = WarpingGrid::ChooseSmoothing(lines, true, 0.01, bendCost);
      EXPECT_GE(smoothing, SmoothingChoice::Least * 0.999);
      EXPECT_LE(smoothing, most * 1.001);
    }
  }
}

// What is asked for changes little from frame to frame, and so does the choice.
TEST(ChosenSmoothing, IsContinuous)
{
  std::mt19937 random(6);
  for (int round = 0; round < 2; ++round)
  {
    const Grid from = RandomSpots(random), to = RandomSpots(random);
    double before = 0;
    for (int step = 0; step <= 100; ++step)
    {
      Grid between = from;
      for (std::size_t line = 0; line < from.size(); ++line)
      {
        for (std::size_t cell = 0; cell < from.size(); ++cell)
        {
          between[line][cell] += step / 100.0 * (to[line][cell] - from[line][cell]);
        }
      }
      const double smoothing = WarpingGrid::ChooseSmoothing(between, true, 0.01, 0);
      EXPECT_TRUE(step == 0 || std::abs(std::log(smoothing / before)) < 0.3) << step;
      before = smoothing;
    }
  }
}
}
