// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwFramedView.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtw
{
namespace
{
// A perspective view is framed where what is seen begins farther from the eye than so many times as
// it is deep: nearer, floats from the eye are as precise.
constexpr double FarAway = 3;
// Share of the depth of what is seen by which view coordinates begin before it.
constexpr double BeforeRange = 1e-3;

// An explicit projection may be anything, and an eye of a stereo pair looks from beside the camera.
bool IsPlain(const View& view)
{
  const glm::dmat4& p = view.ViewToClip;
  const bool fromCamera = view.Parallel || (p[3][0] == 0 && p[3][1] == 0);
  return fromCamera && p[0][2] == 0 && p[1][2] == 0 && p[0][3] == 0 && p[1][3] == 0 &&
    p[2][3] == (view.Parallel ? 0 : -1) && p[3][3] == (view.Parallel ? 1 : 0) &&
    p[2][2] < 0 && (view.Parallel ? p[2][0] == 0 && p[2][1] == 0 : p[3][2] < 0);
}

// The clipping planes' distances from the camera; infinite where rounding leaves no far plane.
glm::dvec2 ClippingRange(const View& view)
{
  const glm::dvec2& row = view.DepthRow;
  if (view.Parallel)
  {
    return glm::dvec2(row.y + 1, row.y - 1) / row.x;
  }
  const double farthest = row.y / (row.x + 1);
  return { row.y / (row.x - 1), farthest > 0 ? farthest : std::numeric_limits<double>::infinity() };
}
}

View Framed(const View& view, const glm::dvec2& seen)
{
  if (view.Framed || !IsPlain(view))
  {
    return view;
  }
  const glm::dvec2 clipped = ClippingRange(view);
  const double from = std::max(seen.x, clipped.x), to = std::min(seen.y, clipped.y);
  const double depth = to - from;
  if (!std::isfinite(depth) || !(depth > 0) || !(view.Parallel || from > FarAway * depth))
  {
    return view;
  }
  View framed = view;
  framed.Framed = true;
  framed.Begin = from - BeforeRange * depth;
  framed.Range = { from, to };
  const glm::dvec3 begin(0, 0, framed.Begin);
  framed.WorldToView = glm::translate(glm::dmat4(1), begin) * view.WorldToView;
  framed.ViewToWorld = glm::translate(view.ViewToWorld, -begin);
  glm::dmat4& p = framed.ViewToClip;
  if (view.Parallel)
  {
    p[2][2] = -2 / depth;
    p[3][2] = -(from + to - 2 * framed.Begin) / depth;
  }
  else
  {
    p[2][2] = -(from + to) / depth;
    p[3][2] = -2 * from * to / depth;
    p = glm::translate(p, -begin);
  }
  framed.ClipToView = glm::inverse(p);
  framed.Origin = glm::dvec3(framed.ViewToWorld[3]);
  framed.Eye = view.Parallel ? framed.Origin : view.Eye;
  return framed;
}

View AtEye(const View& view)
{
  View result = view;
  if (view.BeyondEye() > 0)
  {
    const glm::dvec3 begin(0, 0, view.Begin);
    result.WorldToView = glm::translate(glm::dmat4(1), -begin) * view.WorldToView;
    result.ViewToWorld = glm::translate(view.ViewToWorld, begin);
    result.ViewToClip = glm::translate(view.ViewToClip, begin);
    result.ClipToView = glm::inverse(result.ViewToClip);
    result.Origin = view.Eye;
    result.Framed = false;
    result.Begin = 0;
  }
  return result;
}

glm::dvec3 SeenFrom(const View& view)
{
  if (view.Framed)
  {
    return glm::dvec3(0, 0, view.Parallel ? 1 : view.Begin);
  }
  const glm::dmat4& p = view.ViewToClip;
  const glm::dvec2 shear = glm::dvec2(p[view.Parallel ? 2 : 3]) / glm::dvec2(p[0][0], p[1][1]);
  return glm::dvec3(-shear, view.Parallel ? 1 : 0);
}

glm::dvec2 DepthToSample(const View& view)
{
  const glm::dvec2& row = view.DepthRow;
  const double depth = view.Range.y - view.Range.x;
  if (view.Parallel && view.Framed)
  {
    // Window depth d lies at the distance (1 + row.y - 2 d) / row.x, below 0.
    return glm::dvec2(2 / row.x, view.Range.y - (1 + row.y) / row.x) / depth;
  }
  if (view.Parallel)
  {
    return { -1, 1 };
  }
  // In a perspective clip z = row.x z + row.y and clip w = -z, so that 1/w = (clip z / w + row.x) / row.y.
  const glm::dvec2 inverse = glm::dvec2(2, row.x - 1) / row.y;
  return view.Framed ? (inverse - glm::dvec2(0, 1 / view.Range.y)) * (view.Range.x * view.Range.y / depth)
                     : inverse;
}

glm::dvec2 OwnDepthToSample(const View& view)
{
  return view.Framed || view.Parallel ? glm::dvec2(-1, 1) : DepthToSample(view);
}

glm::dvec4 RayOf(const View& view)
{
  const glm::dmat4& p = view.ViewToClip;
  const glm::dvec2 scale(1 / p[0][0], 1 / p[1][1]);
  const glm::dvec2 offset = view.Parallel
    ? -(glm::dvec2(p[3]) + PlaceOf(view).x * glm::dvec2(p[2])) * scale
    : glm::dvec2(p[2]) * scale;
  return glm::dvec4(scale, offset) * (view.Framed && !view.Parallel ? view.Range.y : 1.0);
}

glm::dvec2 ShearOf(const View& view)
{
  const glm::dvec2 perDistance(SeenFrom(view));
  return view.Framed ? glm::dvec2(0) : view.Parallel ? PlaceOf(view).y * perDistance : perDistance;
}

glm::dvec4 PlaceOf(const View& view)
{
  if (view.Parallel)
  {
    // Window depth 1 - a lies where clip z is 1 - 2 a.
    const glm::dmat4& p = view.ViewToClip;
    return { (1 - p[3][2]) / p[2][2], -2 / p[2][2], 1, 0 };
  }
  if (!view.Framed)
  {
    return { -1, 0, 0, 1 };
  }
  // The distance is far / (1 + slope a).
  const double slope = (view.Range.y - view.Range.x) / view.Range.x;
  return { view.Begin - view.Range.y, view.Begin * slope, 1, slope };
}

glm::dvec3 RayStep(const View& view)
{
  const glm::dmat4& p = view.ViewToClip;
  const double depth = view.Range.y - view.Range.x;
  const double rate = view.Parallel ? 0.5 * p[2][2]
    : view.Framed                   ? view.Range.x * view.Range.y / depth
                                    : 1.0;
  return { 2 / (p[0][0] * view.Width), 2 / (p[1][1] * view.Height), rate };
}
}
