// SPDX-License-Identifier: BSD-3-Clause
// How warping functions are culled, and how they follow the last frame's.
#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using rtw::WarpingFunction;

WarpingFunction RandomFunction(std::mt19937& random, int cells, double floor = 0.01)
{
  std::uniform_real_distribution<double> decade(-3, 3);
  std::vector<double> importance(cells);
  for (double& value : importance)
  {
    value = std::pow(10, decade(random));
  }
  return WarpingFunction::FromImportance(importance, 3, floor);
}

double Width(const WarpingFunction& function, int cell)
{
  return function.GetValues()[cell + 1] - function.GetValues()[cell];
}

TEST(CulledFunction, GivesItsMapToWhatIsUsed)
{
  std::vector<double> importance(64, 0);
  std::vector<bool> used(64, false);
  for (int i = 20; i < 24; ++i)
  {
    importance[i] = 1;
    used[i] = true;
  }
  const auto plain = WarpingFunction::FromImportance(importance, 0, 0.5);
  const auto culled = WarpingFunction::FromImportance(importance, 0, 0.5, used, 0);
  double kept = 0;
  for (int i = 0; i < 64; ++i)
  {
    EXPECT_GT(Width(culled, i), 0.99 * rtw::LeastShare);
    if (used[i])
    {
      kept += Width(culled, i);
      EXPECT_GT(Width(culled, i), 1.1 * Width(plain, i));
    }
    else
    {
      EXPECT_LT(Width(culled, i), 1.01 * rtw::LeastShare);
    }
  }
  EXPECT_NEAR(kept, 1, 64 * rtw::LeastShare);
}

TEST(CulledFunction, SparesWhatTheBlurAndTheFilterReach)
{
  std::vector<double> importance(64, 0);
  importance[20] = importance[21] = 1;
  std::vector<bool> used(32, false); // parts of two cells
  used[10] = true;
  const auto blurred = WarpingFunction::FromImportance(importance, 2, 0.2, used, 0);
  for (int i = 0; i < 64; ++i)
  {
    const bool isNear = i >= 20 - 6 && i <= 21 + 6;
    EXPECT_EQ(Width(blurred, i) > 2 * rtw::LeastShare, isNear) << i;
  }
  const auto plain = WarpingFunction::FromImportance(importance, 0, 0.2);
  for (const double reach : { 0.01, 0.05 })
  {
    const auto filtered = WarpingFunction::FromImportance(importance, 0, 0.2, used, reach);
    // From the ends of what is in use it is as far on the map as a filter reaches, or farther.
    const auto isSpared = [&](int i) { return Width(filtered, i) > 2 * rtw::LeastShare; };
    int below = 20, above = 22;
    while (below > 0 && isSpared(below - 1))
    {
      --below;
    }
    while (above < 64 && isSpared(above))
    {
      ++above;
    }
    EXPECT_LT(below, 20);
    EXPECT_GT(above, 22);
    EXPECT_GE(filtered.GetValues()[20] - filtered.GetValues()[below], reach);
    EXPECT_GE(filtered.GetValues()[above] - filtered.GetValues()[22], reach);
    EXPECT_LT(plain.GetValues()[20] - plain.GetValues()[below + 1], reach);
    for (int i = 0; i < 64; ++i)
    {
      EXPECT_EQ(isSpared(i), i >= below && i < above);
    }
  }
}

TEST(CulledFunction, IsAsBeforeWhereNothingOrAllIsUsed)
{
  std::mt19937 random(1);
  const WarpingFunction function = RandomFunction(random, 100);
  EXPECT_EQ(function.Culled({}, 3, 0.01).GetValues(), function.GetValues());
  EXPECT_EQ(function.Culled({ false, false }, 3, 0.01).GetValues(), function.GetValues());
  const WarpingFunction all = function.Culled(std::vector<bool>(128, true), 3, 0.01);
  for (int i = 0; i <= 100; ++i)
  {
    EXPECT_NEAR(all.GetValues()[i], function.GetValues()[i], 1e-12);
  }
}

TEST(CulledFunction, StaysStrictlyMonotoneInSinglePrecision)
{
  std::vector<double> importance(2048, 0);
  std::vector<bool> used(128, false);
  importance[1024] = 1;
  used[64] = true;
  const auto culled = WarpingFunction::FromImportance(importance, 0, 0.0001, used, 0);
  for (int i = 0; i < 2048; ++i)
  {
    EXPECT_LT(float(culled.GetValues()[i]), float(culled.GetValues()[i + 1]));
    const double middle = (i + 0.5) / 2048;
    EXPECT_NEAR(culled.Inverse(culled.Forward(middle)), middle, 1e-9);
  }
}

TEST(BlendedFunction, IsBetweenBoth)
{
  std::mt19937 random(2);
  const WarpingFunction now = RandomFunction(random, 128), last = RandomFunction(random, 128);
  for (const double share : { 0.0, 0.25, 0.99 })
  {
    const WarpingFunction blended = now.BlendedWith(last, 0, 1, share);
    for (int i = 0; i <= 128; ++i)
    {
      EXPECT_NEAR(blended.GetValues()[i],
        (1 - share) * now.GetValues()[i] + share * last.GetValues()[i], 1e-9);
    }
  }
}

// The last function is the same map of the world wherever the two overlap.
TEST(BlendedFunction, FollowsTheFocus)
{
  std::mt19937 random(3);
  const WarpingFunction last = RandomFunction(random, 512), now = RandomFunction(random, 512);
  const double from = -0.1, to = 0.7;
  const WarpingFunction blended = now.BlendedWith(last, from, to, 1);
  const double low = last.Forward(from), high = last.Forward(to);
  for (int i = 0; i <= 512; ++i)
  {
    const double x = from + (to - from) * i / 512;
    EXPECT_NEAR(blended.GetValues()[i], (last.Forward(x) - low) / (high - low), 1e-3);
  }
}

TEST(BlendedFunction, SettlesWithinAQuarterOfATexel)
{
  std::mt19937 random(4);
  for (const double share : { 0.5, 0.9, 0.99 })
  {
    for (const int resolution : { 256, 4096 })
    {
      const WarpingFunction wanted = RandomFunction(random, 64);
      WarpingFunction function = RandomFunction(random, 64);
      const int frames = rtw::FramesToSettle(share, resolution);
      for (int frame = 0; frame < frames; ++frame)
      {
        function = wanted.BlendedWith(function, 0, 1, share);
      }
      for (int i = 0; i <= 64; ++i)
      {
        EXPECT_NEAR(function.GetValues()[i], wanted.GetValues()[i], 0.25 / resolution);
      }
    }
  }
  EXPECT_EQ(rtw::FramesToSettle(0, 1024), 1);
  EXPECT_EQ(rtw::FramesToSettle(0.5, 1024), 12);
}

TEST(SnappedFunction, StaysWhileItIsGoodEnough)
{
  std::mt19937 random(5);
  const WarpingFunction last = RandomFunction(random, 256);
  EXPECT_NEAR(last.ExcessOver(last), 0, 1e-12);
  // Another part of each function counts more and more.
  double before = 0;
  for (const double share : { 0.05, 0.2, 0.9 })
  {
    const WarpingFunction now = last.BlendedWith(RandomFunction(random, 256), 0, 1, share);
    const double excess = last.ExcessOver(now);
    EXPECT_GT(excess, before);
    before = excess;
    const bool stays = excess <= rtw::SnappingMostExcess;
    EXPECT_EQ(now.SnappedTo(last).GetValues(), (stays ? last : now).GetValues());
  }
  EXPECT_GT(before, rtw::SnappingMostExcess);
}

// The excess is what it says: the error of a density is the sum of demand over it.
TEST(SnappedFunction, KnowsTheErrorOfTheRootOfDemand)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> anything(0.1, 10);
  std::vector<double> demand(200), root(200);
  for (int i = 0; i < 200; ++i)
  {
    demand[i] = anything(random);
    root[i] = std::sqrt(demand[i]);
  }
  const auto best = WarpingFunction::FromImportance(root, 0, 0.0001);
  const auto other = WarpingFunction::FromImportance(demand, 0, 0.0001);
  double least = 0, error = 0;
  for (int i = 0; i < 200; ++i)
  {
    least += demand[i] / Width(best, i);
    error += demand[i] / Width(other, i);
  }
  EXPECT_GT(error, 1.05 * least);
  EXPECT_NEAR(other.ExcessOver(best), error / least - 1, 1e-9);
}

TEST(SnappedFunction, DoesNotStarveWhatComesIntoView)
{
  std::mt19937 random(7);
  const WarpingFunction now = RandomFunction(random, 128);
  std::vector<bool> used(128, true);
  used[127] = false;
  const WarpingFunction last = now.Culled(used, 0, 0);
  EXPECT_EQ(last.ExcessOver(now), std::numeric_limits<double>::infinity());
  EXPECT_EQ(now.SnappedTo(last).GetValues(), now.GetValues());
}

TEST(SnappedFocus, StaysWhileItHolds)
{
  const glm::dvec2 needed(10, 20);
  const glm::dvec2 first = rtw::SnappedEnds(needed, nullptr);
  EXPECT_LT(first.x, 10);
  EXPECT_GT(first.y, 20);
  EXPECT_EQ(rtw::SnappedEnds({ 9.8, 20.2 }, &first), first);
  EXPECT_EQ(rtw::SnappedEnds({ 14, 18 }, &first), first);
  // It grows where it has to, and then stays again.
  const glm::dvec2 grown = rtw::SnappedEnds({ 9, 18 }, &first);
  EXPECT_EQ(grown.y, first.y);
  EXPECT_LT(grown.x, 8);
  EXPECT_EQ(rtw::SnappedEnds({ 8, 19 }, &grown), grown);
  // Too much of it isn't needed.
  const glm::dvec2 small = rtw::SnappedEnds({ 14, 15 }, &grown);
  EXPECT_GT(small.x, 13.5);
  EXPECT_LT(small.y, 15.5);
}
}
