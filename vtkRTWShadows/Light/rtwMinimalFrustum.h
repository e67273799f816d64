// SPDX-License-Identifier: BSD-3-Clause
// The minimal shadow frustum (Milet et al. 2015, section 3.2): the smallest rectangle on the light
// plane around what a view can show of a scene, whichever way it is turned.
#ifndef rtwMinimalFrustum_h
#define rtwMinimalFrustum_h

#include "Light/rtwLightFrame.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace rtw
{
/// Points whose convex hull is what a view and a box have in common; none where they have nothing
/// in common. `clipToWorld` may be a perspective; one that is not a number, or that looks nowhere,
/// has nothing in common with any box.
std::vector<glm::dvec3> VisibleCorners(
  const glm::dmat4& clipToWorld, const glm::dvec3& low, const glm::dvec3& high);

/// The exact orientation of three points: 1 where a, b, c turn to the left, -1 to the right, 0 on a
/// line.
int Orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// The convex hull, counter-clockwise, with no three corners on a line; fewer than three corners
/// where all points lie on one.
std::vector<glm::dvec2> ConvexHull(std::vector<glm::dvec2> points);

/// A rectangle along axes that are turned by `Turn`, in radians.
struct TurnedRectangle
{
  double Turn = 0;
  Rectangle Bounds;

  double Area() const;
};

/// The rectangle of least area around a hull, by rotating calipers, and a billionth wider for
/// rounding; never larger than the one without a turn. Empty for a hull of less than three corners
/// or that is not finite.
std::optional<TurnedRectangle> MinimalRectangle(const std::vector<glm::dvec2>& hull);

/// The minimal rectangle around the corners on the plane of a light whose frame is not turned. A
/// corner behind a spot is replaced by the points where the lines to the other corners reach the
/// spot's nearest distance.
std::optional<TurnedRectangle> MinimalFrustum(
  const LightFrame& frame, const std::vector<glm::dvec3>& corners);

/// The bounds of the corners on the light plane of a frame, however that is turned; a billionth
/// wider for rounding, too.
Rectangle BoundsOnLightPlane(const LightFrame& frame, const std::vector<glm::dvec3>& corners);
}

#endif
