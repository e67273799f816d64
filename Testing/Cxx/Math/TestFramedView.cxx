// SPDX-License-Identifier: BSD-3-Clause
// What view samples hold of a view whose eye is far from what it sees, as the floats of the GPU have it.
#include "Frame/rtwFramedView.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
constexpr double Half = 7; // of what is seen

// Towards the origin, from the distance, and all of what is seen fills it.
rtw::View ViewFrom(bool parallel, double distance, double nearest, double farthest)
{
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.1, -0.7, 0.7));
  rtw::View view;
  view.Parallel = parallel;
  view.WorldToView = glm::lookAt(direction * distance, glm::dvec3(0), glm::dvec3(0, 0, 1));
  view.ViewToWorld = glm::inverse(view.WorldToView);
  view.ViewToClip = parallel ? glm::ortho(-Half, Half, -Half, Half, nearest, farthest)
                             : glm::perspective(2 * std::atan(Half / distance), 1.0, nearest, farthest);
  view.ClipToView = glm::inverse(view.ViewToClip);
  view.Origin = view.Eye = direction * distance;
  view.Forward = -direction;
  view.DepthRow = { view.ViewToClip[2][2], view.ViewToClip[3][2] };
  view.Width = view.Height = 100;
  return view;
}

// The largest distance between a point and what floats make of its sample.
double LargestError(const rtw::View& camera, const rtw::View& framed)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-0.5 * Half, 0.5 * Half);
  const glm::dvec2 toSample = rtw::DepthToSample(framed);
  const glm::vec4 ray(rtw::RayOf(framed)), place(rtw::PlaceOf(framed));
  double largest = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec4 p(any(random), any(random), any(random), 1);
    const glm::dvec4 h = camera.ViewToClip * (camera.WorldToView * p);
    const glm::dvec4 own = framed.ViewToClip * (framed.WorldToView * p);
    EXPECT_NEAR(h.x / h.w, own.x / own.w, 1e-7);
    EXPECT_NEAR(h.y / h.w, own.y / own.w, 1e-7);
    const double picture = 0.5 + 0.5 * h.z / h.w;
    const float a = float(0.5 - 0.5 * own.z / own.w);
    EXPECT_NEAR(a, picture * toSample.x + toSample.y, 1e-4);
    const float divisor = place.z + place.w * a;
    const glm::vec2 xy = (glm::vec2(own) / float(own.w) * glm::vec2(ray) + glm::vec2(ray.z, ray.w)) / divisor;
    const glm::vec3 found(xy, (place.x + place.y * a) / divisor);
    EXPECT_LT(found.z, 0);
    largest = std::max(largest, glm::distance(glm::dvec3(found), glm::dvec3(framed.WorldToView * p)));
  }
  return largest;
}
}

TEST(FramedView, IsPreciseFromAfar)
{
  for (const bool parallel : { true, false })
  {
    for (const double distance : { 1e2, 1e3, 1e5, 1e7 })
    {
      const rtw::View camera = ViewFrom(parallel, distance, distance - 10, distance + 10);
      const rtw::View framed = rtw::Framed(camera, { distance - Half, distance + Half });
      ASSERT_TRUE(framed.Framed);
      EXPECT_LT(LargestError(camera, framed), 4e-7 * Half * 2) << parallel << ' ' << distance;
    }
  }
}

// A near plane behind a parallel camera, and a range that is wide beside what is seen.
TEST(FramedView, DoesNotGoByTheCamerasRange)
{
  for (const glm::dvec3& c :
    { glm::dvec3(20, -500, 500), glm::dvec3(1e4, 1, 1e6), glm::dvec3(3, 0, 30) })
  {
    const double distance = c.x, nearest = c.y, farthest = c.z;
    const rtw::View camera = ViewFrom(true, distance, nearest, farthest);
    const rtw::View framed = rtw::Framed(camera, { distance - Half, distance + Half });
    ASSERT_TRUE(framed.Framed);
    EXPECT_DOUBLE_EQ(framed.Range.x, std::max(distance - Half, nearest));
    EXPECT_DOUBLE_EQ(framed.Range.y, distance + Half);
  }
}

// Floats from the eye are precise where that is near, and an explicit projection may be anything.
TEST(FramedView, LeavesOthersAsTheyAre)
{
  const rtw::View near = ViewFrom(false, 20, 0.1, 1e7);
  EXPECT_FALSE(rtw::Framed(near, { 20 - Half, 20 + Half }).Framed);
  rtw::View sheared = ViewFrom(true, 20, 1, 100);
  sheared.ViewToClip[2][0] = 0.1;
  EXPECT_FALSE(rtw::Framed(sheared, { 13, 27 }).Framed);
  const rtw::View nothing = ViewFrom(true, 20, 1, 100);
  EXPECT_FALSE(rtw::Framed(nothing, { INFINITY, -INFINITY }).Framed);
}

TEST(FramedView, GoesBackToTheEye)
{
  const rtw::View camera = ViewFrom(false, 1e4, 1, 1e5);
  const rtw::View framed = rtw::Framed(camera, { 1e4 - Half, 1e4 + Half });
  const rtw::View back = rtw::AtEye(framed);
  const glm::dvec4 p(1, 2, 3, 1);
  EXPECT_LT(glm::distance(back.WorldToView * p, camera.WorldToView * p), 1e-9);
  EXPECT_LT(glm::distance(glm::dvec3(back.ViewToWorld[3]), camera.Eye), 1e-9);
  const glm::dvec4 h = back.ViewToClip * (back.WorldToView * p), g = camera.ViewToClip * (camera.WorldToView * p);
  EXPECT_NEAR(h.x / h.w, g.x / g.w, 1e-9);
}
