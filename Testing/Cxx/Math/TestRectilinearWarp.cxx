// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using rtw::WarpingFunction;

std::vector<double> RandomImportance(std::mt19937& random, int cells)
{
  // Over six decades, and none at all in a third of the cells.
  std::uniform_real_distribution<double> decade(-3, 3), share(0, 1);
  std::vector<double> importance(cells);
  for (double& value : importance)
  {
    value = share(random) < 1.0 / 3 ? 0 : std::pow(10, decade(random));
  }
  return importance;
}

WarpingFunction RandomFunction(std::mt19937& random, int cells)
{
  return WarpingFunction::FromImportance(
    RandomImportance(random, cells), random() % 2 ? 0 : 3, 0.01);
}

TEST(WarpingFunction, IsTheIdentityUnlessToldOtherwise)
{
  const WarpingFunction function;
  for (const double x : { -0.5, 0.0, 0.25, 1.0, 1.5 })
  {
    EXPECT_DOUBLE_EQ(function.Forward(x), x);
    EXPECT_DOUBLE_EQ(function.Inverse(x), x);
  }
  EXPECT_DOUBLE_EQ(function.GreatestSlope(), 1);
  EXPECT_DOUBLE_EQ(function.Bend(0.1, 0.7), 0);
}

TEST(WarpingFunction, IsTheIdentityWithoutUsableImportance)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { 0.0, infinity, nan })
  {
    for (const double sigma : { 0.0, 3.0 })
    {
      std::vector<double> importance(32, bad == 0 ? 0.0 : 1.0);
      importance[7] = bad;
      const auto function = WarpingFunction::FromImportance(importance, sigma, 0.01);
      ASSERT_EQ(function.GetCells(), 32);
      for (int i = 0; i <= 32; ++i)
      {
        EXPECT_NEAR(function.GetValues()[i], i / 32.0, 1e-15) << bad << " " << sigma;
      }
    }
  }
}

TEST(WarpingFunction, RisesFromNoughtToOne)
{
  std::mt19937 random(1);
  for (const int cells : { 1, 16, 512, 2048 })
  {
    const WarpingFunction function = RandomFunction(random, cells);
    EXPECT_EQ(function.GetValues().front(), 0);
    EXPECT_DOUBLE_EQ(function.GetValues().back(), 1);
    double greatest = 0;
    for (int i = 0; i < cells; ++i)
    {
      EXPECT_GT(function.GetValues()[i + 1], function.GetValues()[i]);
      greatest = std::max(greatest, function.Slope(i));
    }
    EXPECT_EQ(function.GreatestSlope(), greatest);
    EXPECT_GE(greatest, 1 - 1e-12);
  }
}

TEST(WarpingFunction, GivesCellsInProportionToImportance)
{
  const auto function = WarpingFunction::FromImportance({ 1, 2, 4, 1 }, 0, 0.0001);
  const double expected[] = { 0, 0.125, 0.375, 0.875, 1 };
  for (int i = 0; i <= 4; ++i)
  {
    EXPECT_NEAR(function.GetValues()[i], expected[i], 1e-15);
  }
}

TEST(WarpingFunction, StarvesNoCell)
{
  std::vector<double> importance(64, 0);
  importance[20] = 1;
  const auto function = WarpingFunction::FromImportance(importance, 0, 0.01);
  for (int i = 0; i < 64; ++i)
  {
    EXPECT_GE(function.Slope(i), 0.0099);
  }
  // A floor of one leaves nothing to warp where importance is even below the mean.
  const auto even = WarpingFunction::FromImportance(std::vector<double>(64, 3), 2, 1);
  EXPECT_NEAR(even.GreatestSlope(), 1, 1e-12);
}

TEST(WarpingFunction, InverseUndoesForward)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(-0.5, 1.5);
  for (int round = 0; round < 20; ++round)
  {
    const WarpingFunction function = RandomFunction(random, 16 << (round % 6));
    for (int i = 0; i < 500; ++i)
    {
      // Beyond the ends too, where the slope of the last cell goes on.
      const double x = anywhere(random);
      EXPECT_NEAR(function.Inverse(function.Forward(x)), x, 1e-12);
      EXPECT_NEAR(function.Forward(function.Inverse(x)), x, 1e-12);
    }
    for (const double end : { 0.0, 1.0 })
    {
      EXPECT_NEAR(function.Forward(end), end, 1e-15);
      EXPECT_NEAR(function.Inverse(end), end, 1e-15);
    }
  }
}

TEST(WarpingFunction, ExtendsBeyondItsEnds)
{
  const auto function = WarpingFunction::FromImportance({ 1, 3 }, 0, 0.01);
  EXPECT_NEAR(function.Forward(-1), -0.5, 1e-15);
  EXPECT_NEAR(function.Forward(2), 2.5, 1e-15);
  EXPECT_NEAR(function.Inverse(-0.5), -1, 1e-15);
  EXPECT_NEAR(function.Inverse(2.5), 2, 1e-15);
}

TEST(WarpingFunction, BendIsAnUpperBound)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0, 1);
  double tightest = 1e9;
  for (int round = 0; round < 400; ++round)
  {
    const WarpingFunction function = RandomFunction(random, 64);
    const double a = anywhere(random), b = anywhere(random);
    const double low = std::min(a, b), high = std::max(a, b);
    const double bend = function.Bend(low, high);
    double worst = 0;
    for (int i = 0; i <= 1000; ++i)
    {
      const double x = low + (high - low) * i / 1000;
      const double chord =
        function.Forward(low) + (function.Forward(high) - function.Forward(low)) * i / 1000;
      worst = std::max(worst, std::abs(function.Forward(x) - chord));
    }
    EXPECT_LE(worst, bend + 1e-14);
    tightest = std::min(tightest, bend / std::max(worst, 1e-30));
  }
  EXPECT_LT(tightest, 3); // of use as a bound, too
}

TEST(RectilinearWarp, MapsItsFocusToTheWholeMap)
{
  std::mt19937 random(4);
  rtw::RectilinearWarp warp;
  warp.Focus = { { -3, 7 }, { 5, 8 } };
  warp.S = RandomFunction(random, 128);
  warp.T = RandomFunction(random, 64);
  EXPECT_LT(glm::length(warp.Forward({ -3, 7 })), 1e-15);
  EXPECT_LT(glm::length(warp.Forward({ 5, 8 }) - glm::dvec2(1)), 1e-12);
  std::uniform_real_distribution<double> s(-5, 7), t(6.5, 8.5);
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec2 p(s(random), t(random));
    EXPECT_LT(glm::length(warp.Inverse(warp.Forward(p)) - p), 1e-11);
  }
}

TEST(RectilinearWarp, KnowsItsMaximumEffectiveResolution)
{
  rtw::RectilinearWarp warp;
  warp.Focus = { { 0, 0 }, { 0.5, 0.25 } };
  warp.S = WarpingFunction::FromImportance({ 1, 3 }, 0, 0.01);
  const glm::dvec2 resolution = warp.MaximumEffectiveResolution(1024, { { 0, 0 }, { 1, 1 } });
  EXPECT_NEAR(resolution.x, 1024 * 2 * 1.5, 1e-9);
  EXPECT_NEAR(resolution.y, 1024 * 4, 1e-9);
}
}
