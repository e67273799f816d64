// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
using rtw::PerspectiveChoice;
using rtw::PerspectiveWarp;
using rtw::ViewOnLight;

constexpr double Infinity = std::numeric_limits<double>::infinity();

TEST(NearDistance, IsThatOfThePublishedTechniquesAtTheirEta)
{
  for (const double f : { 1.5, 10.0, 1e4 })
  {
    EXPECT_NEAR(rtw::NearOfEta(1, 1, f), 1, 1e-12);
    EXPECT_NEAR(rtw::NearOfEta(0, 1, f), 1 + std::sqrt(f), 1e-12 * f);
    EXPECT_EQ(rtw::NearOfEta(-1, 1, f), Infinity);
    EXPECT_NEAR(rtw::NearOfEta(0.3, 7, 7 * f), 7 * rtw::NearOfEta(0.3, 1, f), 1e-9 * f);
  }
}

TEST(NearDistance, FallsWithEtaWhichItTells)
{
  for (const double f : { 1.5, 10.0, 1e4 })
  {
    double last = Infinity;
    for (double eta = -0.99; eta <= 1; eta += 0.01)
    {
      const double nearDistance = rtw::NearOfEta(eta, 2, 2 * f);
      EXPECT_LT(nearDistance, last);
      EXPECT_NEAR(rtw::EtaOfNear(nearDistance, 2, 2 * f), eta, 1e-9);
      last = nearDistance;
    }
    EXPECT_NEAR(rtw::EtaOfNear(Infinity, 2, 2 * f), -1, 1e-12);
  }
}

// Appendix B: the greatest error along t is linear in eta on either side of LiSPSM.
TEST(NearDistance, GoesByTheErrorAlongT)
{
  constexpr double f = 100;
  const auto error = [](double eta) {
    const double m = rtw::NearOfEta(eta, 1, f);
    return eta < 0 ? m / (m + f - 1) : (m + f - 1) / (m * f);
  };
  for (const double side : { -1.0, 1.0 })
  {
    const double step = error(side * 0.5) - error(0);
    EXPECT_GT(step, 0);
    for (const double eta : { 0.1, 0.25, 0.75, 0.99 })
    {
      EXPECT_NEAR(error(side * eta) - error(0), 2 * eta * step, 1e-12);
    }
  }
}

TEST(NearDistance, OfAFocusPointPutsItOnTheFocusLine)
{
  constexpr double n = 3, f = 900;
  for (const double share : { 0.05, 0.1, 0.3, 0.79 })
  {
    const double nearDistance = rtw::NearOfFocusPoint(share, n, f);
    EXPECT_GE(nearDistance, n);
    const PerspectiveWarp warp{ {}, (f - n) / nearDistance, 0.5, { 0, 1 } };
    EXPECT_NEAR(warp.Forward({ 0.5, share }).y, 0.8, 1e-9);
  }
  EXPECT_EQ(rtw::NearOfFocusPoint(0.8, n, f), Infinity);
  EXPECT_EQ(rtw::NearOfFocusPoint(1, n, f), Infinity);
  EXPECT_EQ(rtw::NearOfFocusPoint(1e-6, n, f), n);
}

// Equations 5 and 6, whose z' is negative as OpenGL has it.
TEST(PerspectiveWarp, IsThePapersProjection)
{
  constexpr double n = 2, f = 40, tangent = 0.6;
  for (const double nearDistance : { 2.0, 5.0, 11.0, 200.0 })
  {
    const double farDistance = nearDistance + f - n;
    const double across = f / farDistance * tangent; // tan θ'
    // The focus holds the frustum, seen from above; the ends its sides' images where t is 0.
    const double half = f * tangent;
    const PerspectiveWarp warp{ { { -half, n }, { half, f } }, (f - n) / nearDistance, 0.5,
      glm::dvec2(0.5) + glm::dvec2(-1, 1) * across * nearDistance / (2 * half) };
    for (const double z : { 2.0, 3.0, 17.0, 40.0 })
    {
      const double away = nearDistance + z - n;
      const double t = (farDistance + nearDistance) / (2 * (farDistance - nearDistance)) -
        farDistance * nearDistance / (away * (farDistance - nearDistance)) + 0.5;
      for (const double x : { -0.4 * z, 0.0, 0.5 * z })
      {
        const glm::dvec2 u = warp.Forward({ x, z });
        EXPECT_NEAR(u.x, x / (2 * away * across) + 0.5, 1e-12);
        EXPECT_NEAR(u.y, t, 1e-12);
      }
    }
  }
}

PerspectiveWarp RandomWarp(std::mt19937& random)
{
  std::uniform_real_distribution<double> decade(-3, 4), place(-0.5, 1.5), share(0.01, 0.4);
  const double low = share(random);
  return { { { -3, 2 }, { 5, 9 } }, std::pow(10, decade(random)), place(random),
    { low, 1 - share(random) } };
}

TEST(PerspectiveWarp, HasAnInverse)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 1000; ++i)
  {
    const PerspectiveWarp warp = RandomWarp(random);
    const glm::dvec2 onMap(place(random), place(random));
    const glm::dvec2 back = warp.Forward(warp.Inverse(onMap));
    EXPECT_NEAR(back.x, onMap.x, 1e-9);
    EXPECT_NEAR(back.y, onMap.y, 1e-9);
  }
}

TEST(PerspectiveWarp, KeepsLinesStraightAndEndsInPlace)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 200; ++i)
  {
    const PerspectiveWarp warp = RandomWarp(random);
    const glm::dvec2 size = warp.Focus.High - warp.Focus.Low;
    const glm::dvec2 a = warp.Focus.Low + size * glm::dvec2(place(random), place(random));
    const glm::dvec2 b = warp.Focus.Low + size * glm::dvec2(place(random), place(random));
    const glm::dvec2 from = warp.Forward(a), to = warp.Forward(b) - from;
    const glm::dvec2 middle = warp.Forward(0.3 * a + 0.7 * b) - from;
    EXPECT_NEAR(to.x * middle.y - to.y * middle.x, 0, 1e-10 * (1 + glm::dot(to, to)));
    EXPECT_NEAR(warp.Forward({ a.x, warp.Focus.Low.y }).y, 0, 1e-12);
    EXPECT_NEAR(warp.Forward({ a.x, warp.Focus.High.y }).y, 1, 1e-12);
  }
}

TEST(PerspectiveWarp, IsNotANumberBehindItsCentre)
{
  const PerspectiveWarp warp{ {}, 4, 0.5, { 0, 1 } };
  EXPECT_TRUE(std::isnan(warp.Forward({ 0.5, -0.25 }).x));
  EXPECT_TRUE(std::isnan(warp.Forward({ 0.5, -3 }).y));
  EXPECT_FALSE(std::isnan(warp.Forward({ 0.5, -0.2 }).y));
}

// As Wimmer et al. 2004 have it for a light that is not overhead: n' = (n + √(n f)) / sin γ.
TEST(PerspectiveStrength, IsThatOfLiSPSM)
{
  constexpr double n = 1.5, extent = 80;
  for (const double sine : { 1.0, 0.4, 0.05 })
  {
    const double f = n + extent / sine;
    const double nearDistance = (n + std::sqrt(n * f)) / sine;
    EXPECT_NEAR(rtw::PerspectiveStrength({ PerspectiveChoice::Eta, 0 }, { sine, 1, 0 }, n, extent),
      extent / nearDistance, 1e-9);
  }
}

TEST(PerspectiveStrength, ComesToNothingSmoothlyAsTheLightNearsTheView)
{
  for (const PerspectiveChoice choice : { PerspectiveChoice{ PerspectiveChoice::Eta, 1 },
         { PerspectiveChoice::Eta, 0 }, { PerspectiveChoice::Near, 3 },
         { PerspectiveChoice::FocusPoint, 0.1 }, { PerspectiveChoice::Eta, -1 } })
  {
    double last = rtw::PerspectiveStrength(choice, { std::sin(0.3), 1, 0 }, 1, 1000);
    for (int i = 3000; i >= -3000; --i)
    {
      const double sine = std::abs(std::sin(1e-4 * i));
      const double strength = rtw::PerspectiveStrength(choice, { sine, 1, 0 }, 1, 1000);
      EXPECT_TRUE(std::isfinite(strength));
      EXPECT_GE(strength, 0);
      EXPECT_LE(std::abs(strength - last), 0.12); // 1000 times the step, at most
      last = strength;
    }
    EXPECT_EQ(rtw::PerspectiveStrength(choice, { 0, 1, 0 }, 1, 1000), 0);
    EXPECT_EQ(rtw::PerspectiveStrength(choice, { 1, 0, 0 }, 1, 1000), 0);
    EXPECT_EQ(rtw::PerspectiveStrength(choice, { 1, 1, 0 }, 0, 1000), 0);
  }
}

TEST(PerspectiveStrength, IsNoMoreThanThatOfPSM)
{
  const ViewOnLight overhead{ 1, 1, 0 };
  const double most = rtw::PerspectiveStrength({ PerspectiveChoice::Eta, 1 }, overhead, 2, 100);
  EXPECT_NEAR(most, 50, 1e-9);
  EXPECT_EQ(rtw::PerspectiveStrength({ PerspectiveChoice::Near, 1e-9 }, overhead, 2, 100), most);
  EXPECT_EQ(
    rtw::PerspectiveStrength({ PerspectiveChoice::FocusPoint, 1e-9 }, overhead, 2, 100), most);
  EXPECT_EQ(rtw::PerspectiveStrength({ PerspectiveChoice::Near, Infinity }, overhead, 2, 100), 0);
  EXPECT_LE(rtw::PerspectiveStrength({ PerspectiveChoice::Eta, 1 }, overhead, 1e-12, 100), 1e4);
}

rtw::LightFrame FrameOf(
  const rtw::ShadowLight& light, const glm::dvec3& eye, const glm::dvec3& forward)
{
  const auto extent = [](const glm::dvec3& direction) {
    const double reach =
      20 * (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    return glm::dvec2(-reach, reach);
  };
  return rtw::MakeLightFrame(light, extent, eye, rtw::ViewAlignedTurn(light, eye, forward, 1e-6));
}

TEST(ViewOnLight, IsTheAngleToADirectionalLight)
{
  rtw::ShadowLight sun;
  sun.Direction = glm::normalize(glm::dvec3(1, -2, 0.5));
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0, -0.2, -1));
  const rtw::LightFrame frame = FrameOf(sun, { 1, 2, 3 }, forward);
  const ViewOnLight view = rtw::LookAtView(frame, { 1, 2, 3 }, forward, false);
  const double cosine = glm::dot(sun.Direction, forward);
  EXPECT_NEAR(view.Sine, std::sqrt(1 - cosine * cosine), 1e-12);
  EXPECT_EQ(view.Unit, 1);
  EXPECT_EQ(view.EyeS, 0);
  EXPECT_EQ(rtw::LookAtView(frame, { 1, 2, 3 }, forward, true).Unit, 0);
}

TEST(ViewOnLight, OfASpotIsWhereItsLightPlaneShowsTheViewersLines)
{
  rtw::ShadowLight spot;
  spot.Kind = rtw::LightKind::Spot;
  spot.Position = { 2, 9, 1 };
  spot.Direction = glm::normalize(glm::dvec3(-0.2, -1, -0.3));
  spot.ConeAngle = 40;
  const glm::dvec3 eye(1, 2, 6), forward = glm::normalize(glm::dvec3(0.1, -0.1, -1));
  const rtw::LightFrame frame = FrameOf(spot, eye, forward);
  const ViewOnLight view = rtw::LookAtView(frame, eye, forward, false);
  EXPECT_GT(view.Sine, 0.5);
  EXPECT_LT(view.Sine, 1);
  // All points of the line of sight are on that line, and the farther, the farther along t.
  double last = frame.Project(eye).y;
  for (const double away : { 1.0, 3.0, 8.0 })
  {
    const glm::dvec3 p = frame.Project(eye + away * forward);
    EXPECT_NEAR(p.x, view.EyeS, 1e-9);
    EXPECT_GT(p.y, last);
    last = p.y;
  }
  // Near the eye, that far in all.
  EXPECT_NEAR((frame.Project(eye + 1e-6 * forward).y - frame.Project(eye).y) * view.Unit / 1e-6,
    view.Sine * glm::length(eye - spot.Position) / view.Unit, 1e-4);
  const glm::dvec3 behind(2, 12, 1);
  EXPECT_EQ(rtw::LookAtView(FrameOf(spot, behind, forward), behind, forward, false).Unit, 0);
}
}
