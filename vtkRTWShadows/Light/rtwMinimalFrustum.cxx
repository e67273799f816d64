// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwMinimalFrustum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rtw
{
namespace
{
using Polygon = std::vector<glm::dvec3>;

constexpr double Wider = 1e-9; // share of its extent that the rectangle is wider, for rounding

// The points on that side of a plane to which its normal points, and the plane itself.
struct HalfSpace
{
  glm::dvec3 Normal;
  double Offset;

  double Distance(const glm::dvec3& p) const { return glm::dot(this->Normal, p) + this->Offset; }
};

// A box, or a frustum: corners by bits, x the lowest.
struct Hexahedron
{
  std::array<glm::dvec3, 8> Corners;

  std::vector<Polygon> Faces() const
  {
    std::vector<Polygon> faces;
    for (const auto& [a, b, c, d] : { std::array<int, 4>{ 0, 2, 6, 4 }, { 1, 3, 7, 5 },
           { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 1, 3, 2 }, { 4, 5, 7, 6 } })
    {
      faces.push_back({ this->Corners[a], this->Corners[b], this->Corners[c], this->Corners[d] });
    }
    return faces;
  }

  std::vector<HalfSpace> HalfSpaces() const
  {
    glm::dvec3 middle(0);
    for (const glm::dvec3& corner : this->Corners)
    {
      middle += corner / 8.0;
    }
    std::vector<HalfSpace> halves;
    for (const Polygon& face : this->Faces())
    {
      // The normal follows from the face's diagonals, because a side of it may be tiny.
      glm::dvec3 normal = glm::cross(face[2] - face[0], face[3] - face[1]);
      const double length = glm::length(normal);
      const glm::dvec3 on = 0.25 * (face[0] + face[1] + face[2] + face[3]);
      normal *= (glm::dot(normal, middle - on) < 0 ? -1 : 1) / (length > 0 ? length : 1);
      halves.push_back({ normal, -glm::dot(normal, on) });
    }
    return halves;
  }
};

Polygon Clip(const Polygon& polygon, const HalfSpace& half)
{
  Polygon inside;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = half.Distance(a), db = half.Distance(b);
    if (da >= 0)
    {
      inside.push_back(a);
    }
    if ((da < 0) != (db < 0))
    {
      inside.push_back(a + da / (da - db) * (b - a));
    }
  }
  return inside;
}

void AddFacesWithin(
  const Hexahedron& body, const std::vector<HalfSpace>& halves, std::vector<glm::dvec3>& corners)
{
  for (Polygon face : body.Faces())
  {
    for (const HalfSpace& half : halves)
    {
      face = Clip(face, half);
    }
    corners.insert(corners.end(), face.begin(), face.end());
  }
}

bool IsFinite(double value)
{
  return std::abs(value) <= std::numeric_limits<double>::max();
}

// Sums that lose nothing (Shewchuk 1997): parts that don't overlap, the largest last.
class ExactSum
{
public:
  void AddProduct(double a, double b)
  {
    const double product = a * b;
    this->Add(std::fma(a, b, -product));
    this->Add(product);
  }
  int Sign() const
  {
    for (std::size_t i = this->Parts.size(); i-- > 0;)
    {
      if (this->Parts[i] != 0)
      {
        return this->Parts[i] > 0 ? 1 : -1;
      }
    }
    return 0;
  }

private:
  void Add(double value)
  {
    for (double& part : this->Parts)
    {
      const double sum = value + part, virtually = sum - value;
      const double rest = (value - (sum - virtually)) + (part - virtually);
      part = rest;
      value = sum;
    }
    this->Parts.push_back(value);
  }
  std::vector<double> Parts;
};

glm::dvec2 TurnedBy(const glm::dvec2& v, const glm::dvec2& axis)
{
  return { axis.x * v.x + axis.y * v.y, axis.x * v.y - axis.y * v.x };
}

Rectangle BoundsAlong(const std::vector<glm::dvec2>& hull, const glm::dvec2& axis)
{
  Rectangle bounds{ glm::dvec2(std::numeric_limits<double>::infinity()),
    glm::dvec2(-std::numeric_limits<double>::infinity()) };
  for (const glm::dvec2& p : hull)
  {
    bounds.Low = glm::min(bounds.Low, TurnedBy(p, axis));
    bounds.High = glm::max(bounds.High, TurnedBy(p, axis));
  }
  return bounds;
}

double AreaOf(const Rectangle& r)
{
  return (r.High.x - r.Low.x) * (r.High.y - r.Low.y);
}

// The unit direction of the hull's edge on which its smallest rectangle lies. While the edge goes
// around the hull, the corners farthest along it, against it and across it go around too.
glm::dvec2 BestAxis(const std::vector<glm::dvec2>& hull)
{
  const std::size_t count = hull.size();
  const auto at = [&](std::size_t i) { return hull[i % count]; };
  std::size_t along = 0, across = 0, against = 0;
  double least = std::numeric_limits<double>::infinity();
  glm::dvec2 best(1, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec2 edge = glm::normalize(at(i + 1) - at(i));
    const glm::dvec2 up(-edge.y, edge.x);
    const auto advance = [&](std::size_t& corner, const glm::dvec2& to, std::size_t first) {
      corner = std::max(corner, first);
      while (corner < first + count && glm::dot(at(corner + 1) - at(corner), to) > 0)
      {
        ++corner;
      }
    };
    advance(along, edge, i + 1);
    advance(across, up, along);
    advance(against, -edge, across);
    const double area = glm::dot(at(along) - at(against), edge) * glm::dot(at(across) - at(i), up);
    if (area < least)
    {
      least = area;
      best = edge;
    }
  }
  return best;
}

// The corners on the light plane. A corner that lies nearer to a spot than its nearest distance is
// replaced by the points where lines from it to the other corners reach that.
std::vector<glm::dvec2> OnLightPlane(
  const LightFrame& frame, const std::vector<glm::dvec3>& corners)
{
  std::vector<glm::dvec4> places;
  for (const glm::dvec3& corner : corners)
  {
    places.push_back(frame.WorldToLight * glm::dvec4(corner, 1));
  }
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  const double nearest = isSpot ? frame.NearestDistance : 0;
  std::vector<glm::dvec2> points;
  for (const glm::dvec4& a : places)
  {
    if (a.w >= nearest)
    {
      points.push_back(glm::dvec2(a) / a.w);
      continue;
    }
    for (const glm::dvec4& b : places)
    {
      if (b.w >= nearest)
      {
        points.push_back(glm::dvec2(a + (nearest - a.w) / (b.w - a.w) * (b - a)) / nearest);
      }
    }
  }
  return points;
}

Rectangle Widened(const Rectangle& r)
{
  const double wider = Wider * glm::length(r.High - r.Low);
  return { r.Low - wider, r.High + wider };
}
}

std::vector<glm::dvec3> VisibleCorners(
  const glm::dmat4& clipToWorld, const glm::dvec3& low, const glm::dvec3& high)
{
  Hexahedron seen, box;
  double sum = 0;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 bits(i & 1, i >> 1 & 1, i >> 2);
    const glm::dvec4 corner = clipToWorld * glm::dvec4(2.0 * bits - 1.0, 1);
    seen.Corners[i] = glm::dvec3(corner) / corner.w;
    box.Corners[i] = low + bits * (high - low);
    sum += glm::dot(glm::abs(seen.Corners[i]) + glm::abs(box.Corners[i]), glm::dvec3(1));
  }
  std::vector<glm::dvec3> corners;
  if (IsFinite(sum))
  {
    AddFacesWithin(seen, box.HalfSpaces(), corners);
    AddFacesWithin(box, seen.HalfSpaces(), corners);
  }
  return corners;
}

int Orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  // The sign is certain if the determinant exceeds its greatest rounding error (Shewchuk 1997).
  if (std::abs(determinant) > 4e-16 * (std::abs(left) + std::abs(right)))
  {
    return determinant > 0 ? 1 : -1;
  }
  ExactSum sum;
  sum.AddProduct(a.x, b.y);
  sum.AddProduct(-a.x, c.y);
  sum.AddProduct(-c.x, b.y);
  sum.AddProduct(-a.y, b.x);
  sum.AddProduct(a.y, c.x);
  sum.AddProduct(c.y, b.x);
  return sum.Sign();
}

std::vector<glm::dvec2> ConvexHull(std::vector<glm::dvec2> points)
{
  const auto before = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return points;
  }
  std::vector<glm::dvec2> hull;
  // The monotone chain of Andrew 1979: the lower hull from left to right, then the upper one back.
  for (int side = 0; side < 2; ++side)
  {
    const std::size_t first = hull.size();
    for (const glm::dvec2& p : points)
    {
      while (hull.size() >= first + 2 && Orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back(); // the other's first
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double TurnedRectangle::Area() const
{
  return AreaOf(this->Bounds);
}

std::optional<TurnedRectangle> MinimalRectangle(const std::vector<glm::dvec2>& hull)
{
  if (hull.size() < 3)
  {
    return {};
  }
  glm::dvec2 axis = BestAxis(hull);
  // Of the rectangle's four directions, the nearest to no turn is taken.
  axis = axis.x + axis.y < 0 ? -axis : axis;
  axis = axis.x < axis.y ? glm::dvec2(axis.y, -axis.x) : axis;
  Rectangle bounds = BoundsAlong(hull, axis);
  const Rectangle plain = BoundsAlong(hull, { 1, 0 });
  if (!(AreaOf(bounds) < AreaOf(plain)))
  {
    axis = { 1, 0 };
    bounds = plain;
  }
  if (!IsFinite(AreaOf(bounds)) || !(AreaOf(bounds) > 0))
  {
    return {};
  }
  return TurnedRectangle{ std::atan2(axis.y, axis.x), Widened(bounds) };
}

std::optional<TurnedRectangle> MinimalFrustum(
  const LightFrame& frame, const std::vector<glm::dvec3>& corners)
{
  return MinimalRectangle(ConvexHull(OnLightPlane(frame, corners)));
}

Rectangle BoundsOnLightPlane(const LightFrame& frame, const std::vector<glm::dvec3>& corners)
{
  return Widened(BoundsAlong(OnLightPlane(frame, corners), { 1, 0 }));
}
}
