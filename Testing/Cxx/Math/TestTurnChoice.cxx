// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwTurnChoice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using rtw::TurnSample;

// Pixels of a plane on a square of the light plane, near ones small, with a clean edge at each.
std::vector<TurnSample> Floor(std::size_t count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<TurnSample> samples;
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec2 place(share(random), share(random));
    const glm::dvec2 step(0.001 * (1 + 5 * place.x), 0.002 * (1 + 3 * place.y));
    samples.push_back({ place, { step.x, 0 }, { 0, step.y } });
  }
  return samples;
}

// The same, of a wall that the light grazes: a thin strip, at so many degrees.
std::vector<TurnSample> Wall(double degrees)
{
  const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  const glm::dmat2 turn(c, s, -s, c);
  std::vector<TurnSample> samples = Floor(16000);
  for (TurnSample& sample : samples)
  {
    const glm::dvec2 thin(0.02, 1);
    sample.Place = turn * (thin * sample.Place);
    sample.ToRight = turn * (thin * sample.ToRight);
    sample.ToAbove = turn * (thin * sample.ToAbove);
  }
  return samples;
}

TEST(TurnChoice, ComparesTheTurnInForceWithAllThatDiffer)
{
  const std::vector<double> turns = rtw::TurnCandidates(0.3, 1.2);
  ASSERT_EQ(turns.size(), 10u);
  EXPECT_EQ(turns.front(), 0.3);
  EXPECT_EQ(turns[1], 0.0);
  EXPECT_NEAR(turns[8], glm::radians(78.75), 1e-12);
  EXPECT_EQ(turns.back(), 1.2);
}

TEST(TurnChoice, StaysUnlessAnotherIsATenthBetter)
{
  const float notANumber = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(rtw::BestTurn({ 1.f, 0.91f, 2.f }), 0u);
  EXPECT_EQ(rtw::BestTurn({ 1.f, 0.91f, 0.89f }), 2u);
  EXPECT_EQ(rtw::BestTurn({ 1.f, 2.f, 0.5f, 0.6f }), 2u);
  EXPECT_EQ(rtw::BestTurn({ 0.f, 0.f, 0.f }), 0u);
  EXPECT_EQ(rtw::BestTurn({ 1.f, notANumber, 0.95f }), 0u);
  EXPECT_EQ(rtw::BestTurn({ notANumber, 1.f }), 0u);
  EXPECT_EQ(rtw::BestTurn({ 1.f, 0.99f, notANumber, 0.5f }), 3u);
  EXPECT_EQ(rtw::BestTurn({}), 0u);
}

TEST(TurnChoice, ComparesAreasWithoutATurnToo)
{
  const std::vector<double> turns = rtw::AreaCandidates(0.3, 1.2);
  ASSERT_EQ(turns.size(), 34u);
  EXPECT_EQ(turns.front(), 0.3);
  EXPECT_EQ(turns[1], 0.0);
  EXPECT_NEAR(turns[32], glm::radians(87.1875), 1e-12);
  EXPECT_EQ(turns.back(), 1.2);
}

TEST(TurnChoice, TakesNoMoreAreaThanWithoutATurn)
{
  const float notANumber = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(rtw::LeastTurn({ 1.f, 1.f, 0.95f }), 0u);
  EXPECT_EQ(rtw::LeastTurn({ 1.f, 1.f, 0.8f, 0.7f }), 3u);
  EXPECT_EQ(rtw::LeastTurn({ 1.f, 0.99f, 0.95f }), 1u);
  EXPECT_EQ(rtw::LeastTurn({ 1.f, 0.8f, 0.7f }), 2u);
  EXPECT_EQ(rtw::LeastTurn({ 0.f, 0.f, 0.f }), 0u);
  EXPECT_EQ(rtw::LeastTurn({ 1.f, notANumber, 0.95f }), 0u);
  EXPECT_EQ(rtw::LeastTurn({ 1.f }), 0u);
  EXPECT_EQ(rtw::LeastTurn({}), 0u);
}

// E = (∫√d ds)² / R along each axis, of which this is the mean, where all is an edge.
TEST(TurnChoice, ErrorIsTheDemandsLeast)
{
  const std::vector<TurnSample> samples = Floor(200000);
  constexpr int cells = 1000, texels = 1024;
  double closed = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    std::vector<double> demand(cells);
    for (const TurnSample& s : samples)
    {
      const double extent = std::hypot(s.ToRight[axis], s.ToAbove[axis]);
      demand[std::size_t(s.Place[axis] * cells)] += cells / extent;
    }
    double sum = 0;
    for (const double value : demand)
    {
      sum += std::sqrt(value) / cells;
    }
    closed += 0.5 * sum * sum / texels;
  }
  EXPECT_NEAR(rtw::TurnError(samples, 0, texels, true) / closed, 1, 0.01);
  // Without a warp all texels are as wide.
  double even = 0;
  for (const TurnSample& s : samples)
  {
    even += 0.5 * (1 / s.ToRight.x + 1 / s.ToAbove.y) / texels;
  }
  EXPECT_NEAR(rtw::TurnError(samples, 0, texels, false) / even, 1, 0.001);
  EXPECT_LT(closed, even);
}

TEST(TurnChoice, ErrorIsLeastAlongAWall)
{
  for (const double degrees : { 0.0, 20.0, 45.0, 70.0 })
  {
    const std::vector<TurnSample> wall = Wall(degrees);
    const double along = rtw::TurnError(wall, glm::radians(degrees), 1024, true);
    // Rows and columns change places.
    EXPECT_NEAR(rtw::TurnError(wall, glm::radians(degrees + 90), 1024, true) / along, 1, 1e-6);
    double least = INFINITY;
    for (const double off : { 11.25, 22.5, 45.0, 67.5 })
    {
      const double error = rtw::TurnError(wall, glm::radians(degrees + off), 1024, true);
      EXPECT_GT(error, 1.2 * along) << degrees << " " << off;
      least = std::min(least, error);
    }
    EXPECT_LT(along, least);
  }
}

TEST(TurnChoice, OnlyEdgesCountAndHowTheyRun)
{
  std::vector<TurnSample> samples = Floor(4000);
  for (TurnSample& s : samples)
  {
    s.AtEdge = false;
  }
  EXPECT_EQ(rtw::TurnError(samples, 0.4, 512, true), 0);
  // Across a column of the map a texel's height is of no matter to where it is.
  const TurnSample upright{ { 0, 0 }, { 1, 0 }, { 0, 1 }, true, { 1, 0 } };
  const TurnSample unknown{ { 0, 0 }, { 1, 0 }, { 0, 1 } };
  EXPECT_NEAR(rtw::Misplacement(upright, { 2, 8 }), 0.5 * std::sqrt(2 * 10.0), 1e-12);
  EXPECT_NEAR(rtw::Misplacement(unknown, { 2, 8 }), 0.5 * 10, 1e-12);
  // A pixel that is nothing on the light plane is as wrong as can be, and not more.
  const TurnSample flat{ { 0, 0 }, { 1, 1 }, { 1, 1 } };
  const double widest = rtw::Misplacement(flat, { 1, 1 });
  EXPECT_TRUE(widest > 10 && std::isfinite(widest));
  EXPECT_EQ(rtw::Misplacement({ { 0, 0 }, { 0, 0 }, { 0, 0 } }, { 1, 1 }), widest);
}
}
