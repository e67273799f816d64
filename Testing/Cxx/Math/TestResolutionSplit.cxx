// SPDX-License-Identifier: BSD-3-Clause
// How texels are split between s and t: beside Equations 9 to 14 of Lloyd et al. 2006, and steady.
#include "Warp/Perspective/rtwResolutionSplit.h"

#include "Frame/rtwView.h"
#include "Partition/rtwStorageFactor.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <vector>

namespace
{
using rtw::PerspectiveChoice;

constexpr double Pi = 3.14159265358979323846;
const rtw::StoredView Stored{ 2, 200, Pi / 7 };

rtw::View MakeView(bool parallel = false)
{
  rtw::View view;
  view.Forward = { 0, 0, -1 };
  view.Parallel = parallel;
  view.Width = view.Height = 512;
  view.ViewToClip = parallel ? glm::ortho(-30.0, 30.0, -10.0, 10.0, Stored.Near, Stored.Far)
                             : glm::perspective(2 * Stored.HalfAngle, 1.0, Stored.Near, Stored.Far);
  view.ClipToView = glm::inverse(view.ViewToClip);
  return view;
}

rtw::LightFrame MakeFrame(const glm::dvec3& direction)
{
  rtw::ShadowLight light;
  light.Direction = glm::normalize(direction);
  const rtw::View view = MakeView();
  return rtw::MakeLightFrame(
    light, [](const glm::dvec3&) { return glm::dvec2(-300, 300); }, view.Eye,
    rtw::ViewAlignedTurn(light, view.Eye, view.Forward, 1e-6));
}

std::vector<glm::dvec3> FrustumCorners()
{
  std::vector<glm::dvec3> corners;
  for (const double depth : { Stored.Near, Stored.Far })
  {
    const double r = depth * std::tan(Stored.HalfAngle);
    for (const glm::dvec2 side :
      { glm::dvec2(-r), glm::dvec2(r, -r), glm::dvec2(-r, r), glm::dvec2(r) })
    {
      corners.emplace_back(side, -depth);
    }
  }
  return corners;
}

double RatioOf(const PerspectiveChoice& choice, const std::vector<rtw::LightFrame>& frames,
  const rtw::View& view, bool focused = true)
{
  const glm::dvec3 far(1e4);
  return rtw::CriticalRatio(choice, { frames, view, -far, far, nullptr, focused });
}

TEST(SplitResolution, KeepsTheTexelsAndMakesErrorsEqual)
{
  const glm::dvec2 split = rtw::SplitResolution(1 << 20, 12, 3);
  EXPECT_NEAR(split.x * split.y, 1 << 20, 1e-6);
  EXPECT_NEAR(12 / split.x, 3 / split.y, 1e-12);
}

TEST(SplitTexels, NeverTakesMoreThanTheSquare)
{
  for (const int side : { 1, 2, 7, 100, 511, 512, 1024, 16384 })
  {
    EXPECT_EQ(rtw::SplitTexels(side, 1, 16384), glm::ivec2(side));
    for (double ratio = 1.0 / 64; ratio < 65; ratio *= 1.3)
    {
      const glm::ivec2 size = rtw::SplitTexels(side, ratio, 16384);
      const double texels = double(side) * side;
      EXPECT_LE(double(size.x) * size.y, texels);
      EXPECT_LE(std::max(size.x, size.y), 16384);
      EXPECT_GE(std::min(size.x, size.y), std::min(side, 8));
      if (side >= 100)
      {
        EXPECT_GT(double(size.x) * size.y, 0.95 * texels);
      }
      if (side > 500 && side < 2000 && ratio > 1.0 / 15 && ratio < 15)
      {
        EXPECT_NEAR(double(size.x) / size.y / ratio, 1, 0.02);
      }
    }
  }
}

TEST(SplitTexels, FallsBackTowardTheSquare)
{
  EXPECT_EQ(rtw::SplitTexels(1000, 4, 1250), glm::ivec2(1250, 800));
  EXPECT_EQ(rtw::SplitTexels(1000, 0.25, 1250), glm::ivec2(800, 1250));
  EXPECT_EQ(rtw::SplitTexels(1000, 4, 1000), glm::ivec2(1000));
  for (const double bad : { std::nan(""), -1.0, 0.0 })
  {
    EXPECT_EQ(rtw::SplitTexels(512, bad, 4096), glm::ivec2(512));
  }
}

TEST(LargestErrors, AreThoseOfEquations9And10ForALightOverhead)
{
  const rtw::LightFrame frame = MakeFrame({ 0, -1, 0 });
  for (double eta = -1; eta <= 1; eta += 0.125)
  {
    const glm::dvec2 errors =
      rtw::LargestErrors({ PerspectiveChoice::Eta, eta }, frame, MakeView(), FrustumCorners());
    const double nearDistance = rtw::NearOfEta(eta, Stored.Near, Stored.Far);
    const double beam = 2 * std::tan(Stored.HalfAngle); // there of the whole image
    EXPECT_NEAR(errors.x / beam / rtw::LargestErrorAcross(Stored, nearDistance), 1, 1e-9);
    EXPECT_NEAR(errors.y / beam / rtw::LargestErrorAlong(Stored, nearDistance), 1, 1e-9);
  }
}

TEST(LargestErrors, AmountToTheStorageFactorForAnyDirection)
{
  const double beam = 2 * std::tan(Stored.HalfAngle);
  for (const glm::dvec3 direction : { glm::dvec3(1, -2, 0.3), glm::dvec3(0.2, -1, -3),
         glm::dvec3(-1, -0.1, 2), glm::dvec3(0, -0.01, 1) })
  {
    const glm::dvec2 errors = rtw::LargestErrors(
      { PerspectiveChoice::Eta, 0 }, MakeFrame(direction), MakeView(), FrustumCorners());
    const double factor = rtw::StorageFactor(
      Stored, { rtw::StorageScheme::LiSPSM, 1, false }, glm::normalize(direction))
                            .Factor;
    EXPECT_NEAR(errors.x * errors.y / (beam * beam) / factor, 1, 1e-6);
  }
}

TEST(LargestErrors, AreNothingWhereASpotDoesNotReach)
{
  rtw::ShadowLight spot;
  spot.Kind = rtw::LightKind::Spot;
  spot.ConeAngle = 30;
  spot.Position = { 0, 50, -50 };
  const auto errors = [&](const glm::dvec3& direction) {
    spot.Direction = direction;
    const rtw::LightFrame frame = rtw::MakeLightFrame(
      spot, [](const glm::dvec3&) { return glm::dvec2(-300, 300); }, { 0, 0, 0 },
      rtw::ViewAlignedTurn(spot, { 0, 0, 0 }, { 0, 0, -1 }, 1e-6));
    return rtw::LargestErrors({ PerspectiveChoice::Eta, 0 }, frame, MakeView(), FrustumCorners());
  };
  const glm::dvec2 reached = errors({ 0, -1, 0 });
  EXPECT_GT(reached.x, 0);
  EXPECT_GT(reached.y, 0);
  EXPECT_TRUE(std::isfinite(reached.x / reached.y));
  EXPECT_EQ(errors({ 0, 1, 0 }), glm::dvec2(0));
}

TEST(CriticalRatio, IsThatOfEquations13And14)
{
  const double n = Stored.Near, f = Stored.Far, beam = 2 * std::tan(Stored.HalfAngle);
  const rtw::LightFrame overhead = MakeFrame({ 0, -1, 0 });
  const PerspectiveChoice lispsm{ PerspectiveChoice::Eta, 0 };
  EXPECT_NEAR(RatioOf(lispsm, { overhead }, MakeView()), beam * f / (f - n), 1e-6);
  // Between η 0 and 1, what one error loses the other gains.
  const double nearDistance = rtw::NearOfEta(0.2, n, f);
  EXPECT_NEAR(RatioOf({ PerspectiveChoice::Eta, 0.2 }, { overhead }, MakeView()),
    rtw::LargestErrorAcross(Stored, nearDistance) / rtw::LargestErrorAlong(Stored, nearDistance),
    1e-6);
  // Of two lights, the mean; of behind the viewer the map is as square as the view.
  const rtw::LightFrame behind = MakeFrame({ 0, 0, -1 });
  EXPECT_NEAR(RatioOf(lispsm, { behind }, MakeView()), 1, 1e-6);
  EXPECT_NEAR(
    RatioOf(lispsm, { overhead, behind }, MakeView()), std::sqrt(beam * f / (f - n)), 1e-6);
}

TEST(CriticalRatio, OfLayersIsThatOfTheirDepths)
{
  std::vector<rtw::LightFrame> layers(4, MakeFrame({ 0, -1, 0 }));
  for (int i = 0; i < 4; ++i)
  {
    layers[i].Parts = 4;
    layers[i].Layer = i;
  }
  const double growth = std::pow(Stored.Far / Stored.Near, 0.25);
  const PerspectiveChoice lispsm{ PerspectiveChoice::Eta, 0 };
  EXPECT_NEAR(RatioOf(lispsm, layers, MakeView()),
    2 * std::tan(Stored.HalfAngle) * growth / (growth - 1), 1e-6);
  for (rtw::LightFrame& layer : layers)
  {
    layer.Faces = 4;
  }
  EXPECT_NEAR(RatioOf(lispsm, layers, MakeView()),
    RatioOf(lispsm, { MakeFrame({ 0, -1, 0 }) }, MakeView()), 1e-6);
}

TEST(CriticalRatio, IsAnExtentsWithoutPerspectiveAndNoneWithoutAView)
{
  const rtw::LightFrame overhead = MakeFrame({ 0, -1, 0 });
  const PerspectiveChoice lispsm{ PerspectiveChoice::Eta, 0 };
  EXPECT_NEAR(RatioOf(lispsm, { overhead }, MakeView(true)), 60 / (Stored.Far - Stored.Near), 1e-6);
  EXPECT_EQ(RatioOf(lispsm, { overhead }, MakeView(), false), 1);
  rtw::View broken = MakeView();
  broken.ViewToClip = broken.ClipToView = glm::dmat4(std::nan(""));
  EXPECT_EQ(RatioOf(lispsm, { overhead }, broken), 1);
}

TEST(LeastErrorStep, IsAnotherOnlyWhereThatIsClearlyBetter)
{
  constexpr int steps = rtw::SplitSteps;
  const auto errors = [](int best, double steepness) {
    std::vector<float> all;
    for (int k = -steps; k <= steps; ++k)
    {
      all.push_back(float(70000 * (1 + steepness * (k - best) * (k - best))));
    }
    return all;
  };
  EXPECT_EQ(rtw::LeastErrorStep({ errors(-3, 0.01) }, 0), -3);
  EXPECT_EQ(rtw::LeastErrorStep({ errors(-1, 0.001) }, {}), -1);
  EXPECT_EQ(rtw::LeastErrorStep({}, {}), 0);
  EXPECT_EQ(rtw::LeastErrorStep({ errors(-3, 0.01) }, -2), -2); // by one percent
  EXPECT_EQ(rtw::LeastErrorStep({ errors(-3, 0.01) }, -5), -3);
  EXPECT_EQ(rtw::LeastErrorStep({ errors(4, 0.01) }, -steps), 4);
  // Of two viewers what is best for both; of none what there is, and without edges about 0.
  EXPECT_EQ(rtw::LeastErrorStep({ errors(-4, 0.1), errors(6, 0.1) }, 0), 1);
  EXPECT_EQ(rtw::LeastErrorStep({}, 2), 2);
  const std::vector<float> none(2 * steps + 1, 0.f);
  EXPECT_EQ(rtw::LeastErrorStep({ none }, 2), 2);
  EXPECT_EQ(rtw::LeastErrorStep({ none }, 8), 0);
  EXPECT_EQ(rtw::LeastErrorStep({ none, errors(-4, 0.1) }, 0), -4);
}

TEST(SteadyRatio, StaysUntilAnotherIsClearlyBetter)
{
  const auto steps = [](double k) { return std::exp2(k / rtw::SteadyRatio::StepsAnOctave); };
  rtw::SteadyRatio ratio;
  EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(2.4)), steps(2));
  EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(2.7)), steps(2));
  EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(1.3)), steps(2));
  EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(2.8)), steps(3));
  // To and fro about the border of two, it is one of them.
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(i % 2 ? 2.4 : 2.6)), steps(3));
  }
  EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(-7)), steps(-7));
  ratio.Forget();
  EXPECT_DOUBLE_EQ(ratio.Choose(nullptr, steps(0.4)), steps(0));
}

TEST(SteadyRatio, IsOneForViewersThatTakeTurns)
{
  rtw::SteadyRatio ratio;
  const int first = 0, second = 0;
  ratio.Choose(&first, 4);
  const double both = ratio.Choose(&second, 0.25);
  EXPECT_DOUBLE_EQ(both, 1);
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_DOUBLE_EQ(ratio.Choose(&first, 4), both);
    EXPECT_DOUBLE_EQ(ratio.Choose(&second, 0.25), both);
  }
  // One that is gone counts no longer.
  for (int i = 0; i < 20; ++i)
  {
    ratio.Choose(&first, 4);
  }
  EXPECT_DOUBLE_EQ(ratio.Choose(&first, 4), 4);
}
}
