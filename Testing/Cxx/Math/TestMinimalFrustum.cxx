// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwMinimalFrustum.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace
{
using glm::dvec2;
using glm::dvec3;
using Points = std::vector<dvec2>;

class Random
{
public:
  explicit Random(unsigned int seed)
    : Engine(seed)
  {
  }
  double operator()(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }
  // Over decades.
  double Size(double least, double most) { return std::pow(10, (*this)(least, most)); }
  dvec3 Point(double size)
  {
    return { (*this)(-size, size), (*this)(-size, size), (*this)(-size, size) };
  }

private:
  std::mt19937 Engine;
};

double Extent(const Points& points, const dvec2& along)
{
  double low = INFINITY, high = -INFINITY;
  for (const dvec2& p : points)
  {
    low = std::min(low, glm::dot(p, along));
    high = std::max(high, glm::dot(p, along));
  }
  return high - low;
}

double AreaAlong(const Points& points, double turn)
{
  const dvec2 axis(std::cos(turn), std::sin(turn));
  return Extent(points, axis) * Extent(points, { -axis.y, axis.x });
}

// A view somewhere about a scene's box, and a light.
struct Setting
{
  glm::dmat4 ClipToWorld;
  dvec3 Low, High;
  rtw::LightFrame Frame;
};

Setting RandomSetting(Random& random)
{
  Setting s;
  const double size = random.Size(-2, 4);
  const dvec3 a = random.Point(size), b = random.Point(size);
  s.Low = glm::min(a, b);
  s.High = glm::max(a, b);
  if (random(0, 1) < 0.05)
  {
    s.High.y = s.Low.y; // all on a floor
  }
  const dvec3 eye = random.Point(1.5 * size);
  const double near = size * random.Size(-4, -1), far = near + size * random.Size(-1, 1);
  const double aspect = random(0.3, 3);
  const glm::dmat4 projection = random(0, 1) < 0.2
    ? glm::ortho(-aspect * size, aspect * size, -size, size, near, far)
    : glm::perspective(glm::radians(random(2, 140)), aspect, near, far);
  const dvec3 focal(
    random(s.Low.x, s.High.x), random(s.Low.y, s.High.y), random(s.Low.z, s.High.z));
  s.ClipToWorld = glm::inverse(glm::lookAt(eye, focal, glm::normalize(random.Point(1)))) *
    glm::inverse(projection);
  rtw::ShadowLight light;
  light.Direction = glm::normalize(random.Point(1));
  if (random(0, 1) < 0.3)
  {
    light.Kind = rtw::LightKind::Spot;
    light.ConeAngle = random(5, 80);
    light.Position = random.Point(3 * size);
  }
  const auto extent = [&s](const dvec3& direction) {
    const dvec3 p = direction * s.Low, q = direction * s.High;
    return dvec2(glm::dot(glm::min(p, q), dvec3(1)), glm::dot(glm::max(p, q), dvec3(1)));
  };
  s.Frame = rtw::MakeLightFrame(light, extent, eye);
  return s;
}

// A point that the view shows of the box, if one is found.
bool Sample(const Setting& s, Random& random, dvec3& sample)
{
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4 p = s.ClipToWorld * glm::dvec4(random.Point(1), 1);
    sample = dvec3(p) / p.w;
    if (glm::all(glm::greaterThanEqual(sample, s.Low)) &&
      glm::all(glm::lessThanEqual(sample, s.High)))
    {
      return true;
    }
    const dvec3 q(random(s.Low.x, s.High.x), random(s.Low.y, s.High.y), random(s.Low.z, s.High.z));
    const glm::dvec4 clip = glm::inverse(s.ClipToWorld) * glm::dvec4(q, 1);
    sample = q;
    if (clip.w > 0 && glm::all(glm::lessThanEqual(glm::abs(dvec3(clip)), dvec3(clip.w))))
    {
      return true;
    }
  }
  return false;
}

TEST(ConvexHull, OfASquareWithPointsInsideIsTheSquare)
{
  const Points hull =
    rtw::ConvexHull({ { 0, 0 }, { 0.5, 0.5 }, { 1, 0 }, { 0.5, 0 }, { 1, 1 }, { 0, 1 }, { 0, 0 } });
  EXPECT_EQ(hull, (Points{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }));
}

TEST(ConvexHull, OfPointsOnALineIsNone)
{
  EXPECT_LT(rtw::ConvexHull({}).size(), 3u);
  EXPECT_LT(rtw::ConvexHull({ { 1, 2 } }).size(), 3u);
  EXPECT_LT(rtw::ConvexHull({ { 1, 2 }, { 1, 2 }, { 1, 2 } }).size(), 3u);
  Points line;
  for (int i = 0; i < 20; ++i)
  {
    line.emplace_back(i * 0.5, 3 - i * 0.25);
  }
  EXPECT_LT(rtw::ConvexHull(line).size(), 3u);
}

TEST(Orientation, IsExactWhereRoundingIsNot)
{
  EXPECT_EQ(rtw::Orientation({ 0, 0 }, { 1, 0 }, { 0, 1 }), 1);
  EXPECT_EQ(rtw::Orientation({ 0, 0 }, { 0, 1 }, { 1, 0 }), -1);
  // About the line from (12, 12) to (24, 24) in steps of the last place: what is exact is the sign
  // of the difference.
  const double step = std::numeric_limits<double>::epsilon() / 2;
  for (int i = 0; i < 64; ++i)
  {
    for (int j = 0; j < 64; ++j)
    {
      const dvec2 p(0.5 + i * step, 0.5 + j * step);
      EXPECT_EQ(rtw::Orientation(p, { 12, 12 }, { 24, 24 }), (j > i) - (j < i)) << i << ", " << j;
    }
  }
}

TEST(MinimalRectangle, OfATurnedRectangleIsThatRectangle)
{
  for (const double turn : { 0.0, 0.3, -0.7, 0.785 })
  {
    Points points;
    for (const dvec2& p : Points{ { 1, 2 }, { 4, 2 }, { 4, 3 }, { 1, 3 }, { 2, 2.5 } })
    {
      points.emplace_back(
        std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y);
    }
    const auto rectangle = rtw::MinimalRectangle(rtw::ConvexHull(points));
    ASSERT_TRUE(rectangle);
    EXPECT_NEAR(rectangle->Area(), 3, 1e-7);
    EXPECT_NEAR(rectangle->Turn, turn, 1e-9);
    EXPECT_NEAR(rectangle->Bounds.Low.x, 1, 1e-7);
    EXPECT_NEAR(rectangle->Bounds.High.y, 3, 1e-7);
  }
}

TEST(MinimalRectangle, IsTheLeastOfAllTurns)
{
  Random random(3);
  for (int round = 0; round < 500; ++round)
  {
    Points points;
    const double flat = random.Size(-3, 0), turn = random(0, 3);
    for (int i = 0; i < 30; ++i)
    {
      const dvec2 p(random(-1, 1), flat * random(-1, 1));
      points.emplace_back(
        std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y);
    }
    const auto rectangle = rtw::MinimalRectangle(rtw::ConvexHull(points));
    ASSERT_TRUE(rectangle);
    double least = INFINITY;
    for (int i = 0; i < 2000; ++i)
    {
      least = std::min(least, AreaAlong(points, i * glm::radians(90.0) / 2000));
    }
    EXPECT_LE(rectangle->Area(), least * (1 + 1e-5));
    EXPECT_NEAR(rectangle->Area(), AreaAlong(points, rectangle->Turn), 1e-5 * least);
  }
}

TEST(MinimalRectangle, IsNoneOfWhatHasNoArea)
{
  EXPECT_FALSE(rtw::MinimalRectangle({}));
  EXPECT_FALSE(rtw::MinimalRectangle({ { 0, 0 }, { 1, 1 } }));
  EXPECT_FALSE(rtw::MinimalRectangle({ { 0, 0 }, { 1, NAN }, { 1, 1 } }));
  EXPECT_FALSE(rtw::MinimalRectangle({ { 0, 0 }, { INFINITY, 0 }, { 1, 1 } }));
}

TEST(MinimalFrustum, IsNoneWhereNothingIsSeen)
{
  const glm::dmat4 away = glm::inverse(glm::perspective(1.0, 1.0, 0.1, 10.0)); // looks along -z
  EXPECT_TRUE(rtw::VisibleCorners(away, { -1, -1, 3 }, { 1, 1, 5 }).empty());
  EXPECT_FALSE(rtw::VisibleCorners(away, { -1, -1, -5 }, { 1, 1, -3 }).empty());
  EXPECT_TRUE(rtw::VisibleCorners(glm::dmat4(NAN), { -1, -1, 3 }, { 1, 1, 5 }).empty());
  EXPECT_TRUE(rtw::VisibleCorners(glm::dmat4(0), { -1, -1, 3 }, { 1, 1, 5 }).empty());
  EXPECT_TRUE(rtw::VisibleCorners(away, dvec3(NAN), dvec3(NAN)).empty());
}

// A million views: never larger than along the axes, and nothing is missing.
TEST(MinimalFrustum, HoldsAllThatIsSeenAndIsNeverLarger)
{
  Random random(5);
  int found = 0, none = 0, larger = 0, samples = 0, missed = 0;
  double shares = 0;
  for (int round = 0; round < 1000000; ++round)
  {
    const Setting s = RandomSetting(random);
    const std::vector<dvec3> corners = rtw::VisibleCorners(s.ClipToWorld, s.Low, s.High);
    const auto minimal = rtw::MinimalFrustum(s.Frame, corners);
    if (!minimal)
    {
      ++none;
      continue;
    }
    ++found;
    const rtw::Rectangle plain = rtw::BoundsOnLightPlane(s.Frame, corners);
    const double area = rtw::TurnedRectangle{ 0, plain }.Area();
    larger += minimal->Area() > area * (1 + 1e-7);
    shares += minimal->Area() / area;
    dvec3 sample;
    if (round % 4 == 0 && Sample(s, random, sample))
    {
      const rtw::LightFrame turned = rtw::Turned(s.Frame, minimal->Turn);
      const dvec3 l = turned.Project(sample);
      if (s.Frame.Light.Kind == rtw::LightKind::Directional ||
        (turned.WorldToLight * glm::dvec4(sample, 1)).w >= s.Frame.NearestDistance)
      {
        ++samples;
        // Corners themselves are as precise as the view's matrix.
        const dvec2 extent = minimal->Bounds.High - minimal->Bounds.Low;
        const double margin = 1e-6 * std::max(extent.x, extent.y);
        missed += l.x < minimal->Bounds.Low.x - margin || l.y < minimal->Bounds.Low.y - margin ||
          l.x > minimal->Bounds.High.x + margin || l.y > minimal->Bounds.High.y + margin;
      }
    }
  }
  std::cout << found << " found, " << none << " that see nothing; " << shares / found
            << " of the area along the axes; " << missed << " of " << samples << " samples missed"
            << std::endl;
  EXPECT_EQ(larger, 0);
  EXPECT_EQ(missed, 0);
  EXPECT_GT(found, 400000);
  EXPECT_GT(samples, 80000);
  EXPECT_LT(shares / found, 0.9);
}
}
