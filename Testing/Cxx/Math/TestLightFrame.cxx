// SPDX-License-Identifier: BSD-3-Clause
#include "rtwLightFrame.h"

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
}
