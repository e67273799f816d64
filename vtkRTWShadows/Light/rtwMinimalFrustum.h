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
/// Corners of what a view and a box have in common, from whose convex hull nothing of it is
/// missing; none where they have nothing. `clipToWorld` may be a perspective; one that is not a
/// number, or that looks nowhere, has nothing in common with any box.
std::vector<glm::dvec3> VisibleCorners(
  const glm::dmat4& clipToWorld, const glm::dvec3& low, const glm::dvec3& high);

/// 1 where a, b, c turn to the left, -1 to the right, 0 on a line: exactly.
int Orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Counter-clockwise, with no three corners on a line; fewer than three where all points are.
std::vector<glm::dvec2> ConvexHull(std::vector<glm::dvec2> points);

/// Along axes that are turned by `Turn`, in radians.
struct TurnedRectangle
{
  double Turn = 0;
  Rectangle Bounds;

  double Area() const;
};

/// The one of least area, by rotating calipers, and a billionth wider for rounding; none larger
/// than that without a turn. Empty for a hull of less than three corners or that is not finite.
std::optional<TurnedRectangle> MinimalRectangle(const std::vector<glm::dvec2>& hull);

/// Of the corners as a light has them whose frame is not turned. Those behind a spot count as where
/// the line to each other corner reaches its nearest distance.
std::optional<TurnedRectangle> MinimalFrustum(
  const LightFrame& frame, const std::vector<glm::dvec3>& corners);

/// What they take of the light plane of a frame, however that is turned; as wide.
Rectangle BoundsOnLightPlane(const LightFrame& frame, const std::vector<glm::dvec3>& corners);
}

#endif
