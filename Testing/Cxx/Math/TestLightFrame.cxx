// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwLightFrame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{
using glm::dvec3;

std::vector<dvec3> RandomPoints(std::mt19937& random, const dvec3& centre, double size)
{
  std::uniform_real_distribution<double> offset(-size, size);
  std::vector<dvec3> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back(centre + dvec3(offset(random), offset(random), offset(random)));
  }
  return points;
}

rtw::ExtentFunction ExtentOf(const std::vector<dvec3>& points)
{
  return [points](const dvec3& direction) {
    glm::dvec2 along(1e300, -1e300);
    for (const dvec3& p : points)
    {
      along.x = std::min(along.x, glm::dot(p, direction));
      along.y = std::max(along.y, glm::dot(p, direction));
    }
    return along;
  };
}

dvec3 RandomDirection(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

void ExpectBasis(const rtw::LightFrame& frame)
{
  EXPECT_NEAR(glm::length(frame.SAxis), 1, 1e-14);
  EXPECT_NEAR(glm::length(frame.TAxis), 1, 1e-14);
  EXPECT_NEAR(glm::dot(frame.SAxis, frame.TAxis), 0, 1e-14);
  EXPECT_NEAR(glm::dot(frame.SAxis, frame.Light.Direction), 0, 1e-14);
}

rtw::ShadowLight Sun(const dvec3& direction)
{
  rtw::ShadowLight light;
  light.Direction = direction;
  return light;
}

rtw::ShadowLight Spot(const dvec3& position, const dvec3& direction, double cone)
{
  rtw::ShadowLight light = Sun(direction);
  light.Kind = rtw::LightKind::Spot;
  light.Position = position;
  light.ConeAngle = cone;
  return light;
}

TEST(LightFrame, HoldsTheSceneOfADirectionalLight)
{
  std::mt19937 random(1);
  // The worst directions for a basis are the axes themselves.
  std::vector<dvec3> directions{ { 0, -1, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, -1 } };
  for (int i = 0; i < 30; ++i)
  {
    directions.push_back(RandomDirection(random));
  }
  for (const dvec3& direction : directions)
  {
    const dvec3 eye(4, 5, 6);
    const auto points = RandomPoints(random, { 1, 2, 3 }, 5);
    const auto frame = rtw::MakeLightFrame(Sun(direction), ExtentOf(points), eye);
    ExpectBasis(frame);
    const glm::dvec2 size = frame.Bounds.High - frame.Bounds.Low;
    EXPECT_NEAR(size.x, size.y, 1e-12 * size.x);
    for (const dvec3& p : points)
    {
      const dvec3 q = frame.Project(p);
      EXPECT_GT(q.z, 0);
      EXPECT_LT(q.z, 1);
      EXPECT_TRUE(q.x >= frame.Bounds.Low.x && q.x <= frame.Bounds.High.x);
      EXPECT_TRUE(q.y >= frame.Bounds.Low.y && q.y <= frame.Bounds.High.y);
      // Depth grows along the light, by what DepthOfLength says.
      const dvec3 next = frame.Project(p + 0.25 * direction);
      EXPECT_NEAR(next.z - q.z, 0.25 * frame.DepthOfLength(), 1e-12);
      EXPECT_NEAR(next.x, q.x, 1e-12);
    }
  }
}

TEST(LightFrame, HasItsOriginAtTheEye)
{
  std::mt19937 random(2);
  // Far from the world's origin the coordinates near the eye stay small.
  const dvec3 eye(1e7, -3e6, 2e7);
  const auto points = RandomPoints(random, eye, 5);
  const dvec3 direction = RandomDirection(random);
  const auto sun = rtw::MakeLightFrame(Sun(direction), ExtentOf(points), eye);
  EXPECT_LT(glm::length(glm::dvec2(sun.Project(eye))), 1e-7);
  const auto spot =
    rtw::MakeLightFrame(Spot(eye - 20.0 * direction, direction, 40), ExtentOf(points), eye);
  EXPECT_LT(glm::length(glm::dvec2(spot.Project(eye))), 1e-7);
  for (const dvec3& p : points)
  {
    const dvec3 q = sun.Project(p), r = spot.Project(p);
    EXPECT_LT(std::max(std::abs(q.x), std::abs(q.y)), 10);
    EXPECT_TRUE(q.z > 0 && q.z < 1);
    EXPECT_TRUE(r.z > 0 && r.z < 1);
  }
}

TEST(LightFrame, HoldsTheConeOfASpot)
{
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round)
  {
    const dvec3 direction = RandomDirection(random), position(1, -2, 3), eye(4, 4, 4);
    const double cone = 5 + 80.0 * round / 29;
    const auto points = RandomPoints(random, position + 8.0 * direction, 4);
    const auto frame = rtw::MakeLightFrame(Spot(position, direction, cone), ExtentOf(points), eye);
    ExpectBasis(frame);
    EXPECT_NEAR(frame.ConeTangent, std::tan(glm::radians(cone)), 1e-12);
    for (const dvec3& p : points)
    {
      const dvec3 way = p - position;
      const double along = glm::dot(way, direction);
      const dvec3 q = frame.Project(p);
      if (along < frame.NearestDistance)
      {
        continue;
      }
      EXPECT_TRUE(q.z > -1e-12 && q.z < 1) << q.z;
      // The tangent of the angle to the axis is the distance to the cone's centre.
      const double tangent = glm::length(way - along * direction) / along;
      EXPECT_NEAR(glm::length(glm::dvec2(q) - frame.ConeCentre), tangent, 1e-9 * (1 + tangent));
      if (tangent < frame.ConeTangent)
      {
        EXPECT_TRUE(q.x >= frame.Bounds.Low.x && q.x <= frame.Bounds.High.x);
        EXPECT_TRUE(q.y >= frame.Bounds.Low.y && q.y <= frame.Bounds.High.y);
      }
    }
    // Depth is linear over any plane: halfway in light-plane coordinates is halfway in depth.
    const dvec3 a = points[0], b = points[1];
    const dvec3 qa = frame.Project(a), qb = frame.Project(b);
    const double wa = glm::dot(a - position, direction), wb = glm::dot(b - position, direction);
    if (wa > 0 && wb > 0)
    {
      const dvec3 middle = (a / wa + b / wb) / (1 / wa + 1 / wb);
      const dvec3 qm = frame.Project(middle);
      EXPECT_LT(glm::length(qm - 0.5 * (qa + qb)), 1e-9 * (1 + glm::length(qa) + glm::length(qb)));
    }
  }
}

TEST(LightFrame, IsInfiniteBehindASpot)
{
  const auto frame = rtw::MakeLightFrame(
    Spot({ 0, 5, 0 }, { 0, -1, 0 }, 30), ExtentOf({ { -1, 0, -1 }, { 1, 1, 1 } }), { 0, 2, 8 });
  EXPECT_TRUE(std::isinf(frame.Project({ 0, 6, 0 }).x));
  EXPECT_TRUE(std::isinf(frame.Project({ 3, 5, 0 }).x));
  EXPECT_TRUE(std::isfinite(frame.Project({ 0, 4, 0 }).x));
}

TEST(LightFrame, IsFiniteForFlatAndEmptyScenes)
{
  for (const auto& points :
    { std::vector<dvec3>{ { 0, 0, 0 } }, std::vector<dvec3>{ { -1, 0, -1 }, { 1, 0, 1 } } })
  {
    for (const auto& light : { Sun({ 0, -1, 0 }), Spot({ 0, 3, 0 }, { 0, -1, 0 }, 30) })
    {
      const auto frame = rtw::MakeLightFrame(light, ExtentOf(points), { 0, 1, 5 });
      for (const dvec3& p : points)
      {
        const dvec3 q = frame.Project(p);
        EXPECT_TRUE(std::isfinite(q.x) && std::isfinite(q.y)) << q.x;
        EXPECT_TRUE(q.z >= 0 && q.z <= 1) << q.z;
      }
      EXPECT_GT(frame.Bounds.High.x, frame.Bounds.Low.x);
    }
  }
}

// By 0 it is the frame as it always was; by more its axes turn about the light, and with them all
// that is on the plane.
TEST(LightFrame, Turns)
{
  std::mt19937 random(4);
  for (int round = 0; round < 20; ++round)
  {
    const dvec3 direction = RandomDirection(random), eye(4, 5, 6);
    const auto points = RandomPoints(random, dvec3(1, 2, 3) + 9.0 * direction, 4);
    for (const auto& light : { Sun(direction), Spot({ 1, 2, 3 }, direction, 40) })
    {
      const auto still = rtw::MakeLightFrame(light, ExtentOf(points), eye);
      const auto same = rtw::MakeLightFrame(light, ExtentOf(points), eye, 0);
      EXPECT_EQ(same.SAxis, still.SAxis);
      EXPECT_EQ(same.WorldToLight, still.WorldToLight);
      const double turn = 0.3 * round - 3;
      const auto turned = rtw::MakeLightFrame(light, ExtentOf(points), eye, turn);
      ExpectBasis(turned);
      EXPECT_NEAR(glm::dot(turned.SAxis, still.SAxis), std::cos(turn), 1e-12);
      EXPECT_NEAR(glm::dot(turned.SAxis, still.TAxis), std::sin(turn), 1e-12);
      const dvec3 from = still.Project(points[0]), turnedFrom = turned.Project(points[0]);
      for (const dvec3& p : points)
      {
        const dvec3 a = still.Project(p) - from, b = turned.Project(p) - turnedFrom;
        EXPECT_NEAR(b.x, std::cos(turn) * a.x + std::sin(turn) * a.y, 1e-9);
        EXPECT_NEAR(b.y, std::cos(turn) * a.y - std::sin(turn) * a.x, 1e-9);
        // Depth of a directional light has a margin that goes with the bounds.
        EXPECT_TRUE(light.Kind == rtw::LightKind::Directional || std::abs(b.z - a.z) < 1e-12);
        const dvec3 q = turned.Project(p);
        EXPECT_TRUE(light.Kind == rtw::LightKind::Spot ||
          (q.x >= turned.Bounds.Low.x && q.x <= turned.Bounds.High.x));
        EXPECT_TRUE(light.Kind == rtw::LightKind::Spot ||
          (q.y >= turned.Bounds.Low.y && q.y <= turned.Bounds.High.y));
      }
    }
  }
}

// A frame that is turned later is that which was made so, but for bounds that still hold all.
TEST(LightFrame, TurnsLater)
{
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round)
  {
    const dvec3 direction = RandomDirection(random), eye(4, 5, 6);
    const auto points = RandomPoints(random, dvec3(1, 2, 3) + 9.0 * direction, 4);
    for (const auto& light : { Sun(direction), Spot({ 1, 2, 3 }, direction, 40) })
    {
      const double turn = 0.3 * round - 3;
      const auto made = rtw::MakeLightFrame(light, ExtentOf(points), eye, 0.2 + turn);
      const auto turned = rtw::Turned(rtw::MakeLightFrame(light, ExtentOf(points), eye, 0.2), turn);
      ExpectBasis(turned);
      EXPECT_NEAR(glm::distance(turned.SAxis, made.SAxis), 0, 1e-12);
      EXPECT_NEAR(glm::distance(turned.ConeCentre, made.ConeCentre), 0, 1e-9);
      for (const dvec3& p : points)
      {
        const glm::dvec2 a = made.Project(p), b = turned.Project(p);
        EXPECT_NEAR(glm::distance(a, b), 0, 1e-9);
        EXPECT_TRUE(light.Kind == rtw::LightKind::Spot ||
          (b.x >= turned.Bounds.Low.x && b.x <= turned.Bounds.High.x &&
            b.y >= turned.Bounds.Low.y && b.y <= turned.Bounds.High.y));
      }
      if (light.Kind == rtw::LightKind::Spot)
      {
        EXPECT_NEAR(glm::distance(turned.Bounds.Low, made.Bounds.Low), 0, 1e-9);
        EXPECT_NEAR(glm::distance(turned.Bounds.High, made.Bounds.High), 0, 1e-9);
      }
    }
  }
}

// What lies ahead of the eye is seen by the light along t, and rising.
TEST(LightFrame, AlignsWithTheView)
{
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round)
  {
    const dvec3 direction = RandomDirection(random), position(1, -2, 3);
    const dvec3 eye = position + 5.0 * direction + RandomDirection(random);
    const dvec3 forward = RandomDirection(random);
    const auto points = RandomPoints(random, position + 8.0 * direction, 4);
    for (const auto& light : { Sun(direction), Spot(position, direction, 60) })
    {
      const double turn = rtw::ViewAlignedTurn(light, eye, forward);
      const auto frame = rtw::MakeLightFrame(light, ExtentOf(points), eye, turn);
      const dvec3 near = frame.Project(eye + 0.1 * forward),
                  far = frame.Project(eye + 2.0 * forward);
      EXPECT_NEAR(near.x, far.x, 1e-9);
      EXPECT_GT(far.y, near.y);
    }
  }
}

TEST(LightFrame, StaysWhereTheViewIsAlongTheLight)
{
  std::mt19937 random(6);
  for (int round = 0; round < 30; ++round)
  {
    const dvec3 direction = RandomDirection(random),
                aside = glm::cross(direction, dvec3(0.6, 0, 0.8));
    for (const double sign : { -1.0, 1.0 })
    {
      const dvec3 forward = glm::normalize(sign * direction + 0.005 * aside);
      EXPECT_EQ(rtw::ViewAlignedTurn(Sun(direction), { 1, 2, 3 }, forward), 0);
      EXPECT_EQ(rtw::ViewAlignedTurn(
                  Spot({ 1, 2, 3 }, direction, 40), dvec3(1, 2, 3) + 7.0 * forward, forward),
        0);
    }
    // Nor is there a direction where the eye is at the spot, nor in a view that is not a number.
    EXPECT_EQ(rtw::ViewAlignedTurn(Spot({ 1, 2, 3 }, direction, 40), { 1, 2, 3 }, aside), 0);
    EXPECT_EQ(rtw::ViewAlignedTurn(Sun(direction), { 1, 2, 3 }, dvec3(NAN)), 0);
  }
}
}
