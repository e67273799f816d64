// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwView.h"
#include "Partition/rtwDepthSplits.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace rtw;

namespace
{
View ViewFrom(
  const glm::dvec3& eye, const glm::dvec3& focal, double nearest = 0.5, double farthest = 100)
{
  View view;
  view.WorldToView = glm::lookAt(eye, focal, glm::dvec3(0, 1, 0));
  view.ViewToWorld = glm::inverse(view.WorldToView);
  view.ViewToClip = glm::perspective(0.9, 1.3, nearest, farthest);
  view.ClipToView = glm::inverse(view.ViewToClip);
  view.Eye = eye;
  view.Forward = glm::normalize(focal - eye);
  view.Width = view.Height = 100;
  return view;
}

LightFrame FrameFrom(LightKind kind, const glm::dvec3& eye)
{
  ShadowLight light;
  light.Kind = kind;
  light.Direction = glm::normalize(glm::dvec3(0.3, -1, 0.2));
  light.Position = { 0, 60, 0 };
  light.ConeAngle = 60;
  const auto extent = [](const glm::dvec3& d) {
    const double most = 200 * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    return glm::dvec2(-most, most);
  };
  return MakeLightFrame(light, extent, eye);
}

double Error(const std::vector<DepthBin>& bins, int first, int end)
{
  glm::dvec2 low(1e30), high(-1e30), demand(0);
  for (int i = first; i < end; ++i)
  {
    if (bins[i].Any)
    {
      low = glm::min(low, bins[i].Bounds.Low);
      high = glm::max(high, bins[i].Bounds.High);
      demand += bins[i].Demand;
    }
  }
  return low.x > high.x ? 0 : glm::dot(high - low, demand);
}
}

// Lloyd et al. 2006, equations 15 and 16: every part has the same ratio.
TEST(DepthSplits, Logarithmic)
{
  const std::vector<double> borders = SplitDepths({ 2, 162 }, 4, 1);
  ASSERT_EQ(borders.size(), 5u);
  for (int k = 0; k < 5; ++k)
  {
    EXPECT_NEAR(borders[k], 2 * std::pow(3.0, k), 1e-9);
  }
}

TEST(DepthSplits, UniformAndPractical)
{
  const std::vector<double> even = SplitDepths({ 2, 162 }, 4, 0);
  const std::vector<double> ratio = SplitDepths({ 2, 162 }, 4, 1);
  const std::vector<double> between = SplitDepths({ 2, 162 }, 4, 0.25);
  for (int k = 0; k < 5; ++k)
  {
    EXPECT_NEAR(even[k], 2 + 40 * k, 1e-9);
    EXPECT_NEAR(between[k], 0.25 * ratio[k] + 0.75 * even[k], 1e-9);
  }
  EXPECT_EQ(SplitDepths({ 2, 162 }, 1, 0.5), (std::vector<double>{ 2, 162 }));
}

// No other choice of two borders has less error.
TEST(DepthSplits, BinsAreTheBest)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<DepthBin> bins(16);
    for (DepthBin& bin : bins)
    {
      bin.Any = number(random) < 0.7;
      bin.Bounds.Low = { number(random), number(random) };
      bin.Bounds.High = bin.Bounds.Low + glm::dvec2(number(random), number(random));
      bin.Demand = bin.Any ? glm::dvec2(number(random), number(random)) : glm::dvec2(0);
    }
    double least = 1e30;
    for (int a = 0; a <= 16; ++a)
    {
      for (int b = a; b <= 16; ++b)
      {
        least = std::min(least, Error(bins, 0, a) + Error(bins, a, b) + Error(bins, b, 16));
      }
    }
    const std::vector<int> firsts = SplitBins(bins, 3);
    ASSERT_EQ(firsts.size(), 3u);
    EXPECT_EQ(firsts[0], 0);
    EXPECT_LE(firsts[1], firsts[2]);
    const double found =
      Error(bins, 0, firsts[1]) + Error(bins, firsts[1], firsts[2]) + Error(bins, firsts[2], 16);
    EXPECT_NEAR(found, least, 1e-12);
  }
}

TEST(DepthSplits, SteadyRangeStays)
{
  const glm::dvec3 eye(0), focal(0, 0, -1);
  const glm::dvec2 range = SteadyRange(ViewFrom(eye, focal, 0.52, 93), glm::dvec2(0));
  EXPECT_LE(range.x, 0.52);
  EXPECT_GE(range.y, 93);
  EXPECT_LT(range.y, 93 * 1.3);
  EXPECT_EQ(range, SteadyRange(ViewFrom(eye, focal, 0.3, 60), range));
  EXPECT_EQ(range, SteadyRange(ViewFrom(eye, focal, 2, 110), range));
  EXPECT_NE(range, SteadyRange(ViewFrom(eye, focal, 0.1, 60), range));
  EXPECT_NE(range, SteadyRange(ViewFrom(eye, focal, 0.5, 130), range));
  EXPECT_NE(range, SteadyRange(ViewFrom(eye, focal, 0.5, 20), range));
}

// Whatever the camera does: as large, by whole texels, and around all that is seen.
TEST(DepthSplits, SteadyFocus)
{
  constexpr int resolution = 256;
  const glm::dvec2 depths(3, 20);
  double side = 0;
  glm::dvec2 first(0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-10, 10);
  for (int i = 0; i < 50; ++i)
  {
    const glm::dvec3 eye(number(random), number(random), number(random));
    const View view = ViewFrom(eye, eye + glm::dvec3(number(random), 0.3, number(random)));
    const LightFrame frame = FrameFrom(LightKind::Directional, eye);
    const Rectangle focus = SteadyFocus(frame, view, depths, { 0.5, 0.01 }, resolution);
    const double texel = (focus.High.x - focus.Low.x) / resolution;
    // From the eye, where light-plane coordinates begin, to a place in the world.
    const glm::dvec2 place = (focus.Low - glm::dvec2(frame.WorldToLight[3])) / texel;
    if (i == 0)
    {
      side = focus.High.x - focus.Low.x;
      first = place;
    }
    EXPECT_NEAR(focus.High.x - focus.Low.x, side, 1e-9);
    EXPECT_NEAR(focus.High.y - focus.Low.y, side, 1e-9);
    const glm::dvec2 moved = place - first;
    EXPECT_NEAR(moved.x, std::round(moved.x), 1e-6);
    EXPECT_NEAR(moved.y, std::round(moved.y), 1e-6);
    for (const glm::dvec3& corner : SliceCorners(view, depths.x, depths.y))
    {
      const glm::dvec2 q = (glm::dvec2(frame.Project(corner)) - focus.Low) / side;
      EXPECT_GE(std::min(q.x, q.y), 0.01);
      EXPECT_LE(std::max(q.x, q.y), 0.99);
    }
  }
}

TEST(DepthSplits, SteadyFocusOfSpot)
{
  constexpr int resolution = 256;
  double side = 0;
  for (int i = 0; i < 10; ++i)
  {
    const glm::dvec3 eye(0.2 * i, 5, 10);
    const View view = ViewFrom(eye, eye + glm::dvec3(0, -0.2, -1));
    const LightFrame frame = FrameFrom(LightKind::Spot, eye);
    const Rectangle focus = SteadyFocus(frame, view, { 3, 20 }, {}, resolution);
    const double texel = (focus.High.x - focus.Low.x) / resolution;
    side = i == 0 ? focus.High.x - focus.Low.x : side;
    EXPECT_NEAR(focus.High.x - focus.Low.x, side, 1e-9);
    const glm::dvec2 place = (focus.Low - frame.ConeCentre) / texel;
    EXPECT_NEAR(place.x, std::round(place.x), 1e-6);
    EXPECT_NEAR(place.y, std::round(place.y), 1e-6);
  }
}
