// SPDX-License-Identifier: BSD-3-Clause
#include "rtwGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rtw
{
namespace
{
// The root of a quadratic a t² + 2 b t + c, without the cancellation of the textbook's formula.
bool Solve(double a, double b, double c, double roots[2])
{
  const double discriminant = b * b - a * c;
  if (discriminant < 0)
  {
    return false;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  roots[0] = q / a;
  roots[1] = q == 0 ? 0 : c / q;
  if (roots[0] > roots[1])
  {
    std::swap(roots[0], roots[1]);
  }
  return true;
}

// The crossing that is nearer to a distance known approximately.
double Nearer(const double distances[2], double about)
{
  return std::abs(distances[0] - about) <= std::abs(distances[1] - about) ? distances[0]
                                                                          : distances[1];
}

SurfacePoint Meet(const Geometry& geometry, const Triangle& triangle, const Ray& ray, double about)
{
  const dvec3& a = geometry.Points[triangle.Corners.x];
  const dvec3 cross =
    glm::cross(geometry.Points[triangle.Corners.y] - a, geometry.Points[triangle.Corners.z] - a);
  const dvec3 normal = cross / glm::length(cross);
  const double along = glm::dot(normal, ray.Direction);
  // Seen edge-on, the plane does not tell the distance.
  const double distance = std::abs(along) > 1e-9 ? glm::dot(a - ray.Origin, normal) / along : about;
  return { ray.At(distance), normal };
}

SurfacePoint Meet(const Ball& ball, const Ray& ray, double about)
{
  double distances[2];
  const dvec3 p = ray.At(Cross(ball, ray, distances) ? Nearer(distances, about) : about);
  return { p, glm::normalize(p - ball.Centre) };
}

SurfacePoint Meet(const Stick& stick, const Ray& ray, double about)
{
  double distances[2];
  const dvec3 p = ray.At(Cross(stick, ray, distances) ? Nearer(distances, about) : about);
  const double along = glm::dot(p - stick.Centre, stick.Axis);
  const dvec3 across = p - stick.Centre - along * stick.Axis;
  const double toSide = stick.Radius - glm::length(across);
  const bool atEnd = stick.HalfLength - std::abs(along) < toSide;
  return { p, atEnd ? stick.Axis : glm::normalize(across) };
}
}

double Geometry::Diagonal() const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  dvec3 low(infinity), high(-infinity);
  const auto add = [&](const dvec3& centre, double reach) {
    low = glm::min(low, centre - reach);
    high = glm::max(high, centre + reach);
  };
  for (const dvec3& p : this->Points)
  {
    add(p, 0);
  }
  for (const Ball& ball : this->Balls)
  {
    add(ball.Centre, ball.Radius);
  }
  for (const Stick& stick : this->Sticks)
  {
    add(stick.Centre, std::hypot(stick.HalfLength, stick.Radius));
  }
  return low.x <= high.x ? glm::distance(low, high) : 0;
}

const PropTraits& Traits(const Geometry& geometry, const Primitive& primitive)
{
  switch (primitive.Kind)
  {
    case Shape::BALL:
      return geometry.Props[geometry.Balls[primitive.Index].Prop];
    case Shape::STICK:
      return geometry.Props[geometry.Sticks[primitive.Index].Prop];
    default:
      return geometry.Props[geometry.Triangles[primitive.Index].Prop];
  }
}

SurfacePoint Meet(
  const Geometry& geometry, const Primitive& primitive, const Ray& ray, double about)
{
  switch (primitive.Kind)
  {
    case Shape::BALL:
      return Meet(geometry.Balls[primitive.Index], ray, about);
    case Shape::STICK:
      return Meet(geometry.Sticks[primitive.Index], ray, about);
    default:
      return Meet(geometry, geometry.Triangles[primitive.Index], ray, about);
  }
}

bool Cross(const Ball& ball, const Ray& ray, double distances[2])
{
  const dvec3 p = ray.Origin - ball.Centre;
  return Solve(
    1, glm::dot(p, ray.Direction), glm::dot(p, p) - ball.Radius * ball.Radius, distances);
}

bool Cross(const Stick& stick, const Ray& ray, double distances[2])
{
  const dvec3 p = ray.Origin - stick.Centre;
  const double start = glm::dot(p, stick.Axis), slope = glm::dot(ray.Direction, stick.Axis);
  const dvec3 across = p - start * stick.Axis, turn = ray.Direction - slope * stick.Axis;
  const double a = glm::dot(turn, turn), c = glm::dot(across, across) - stick.Radius * stick.Radius;
  distances[0] = -std::numeric_limits<double>::infinity();
  distances[1] = std::numeric_limits<double>::infinity();
  if (a > 1e-24 ? !Solve(a, glm::dot(across, turn), c, distances) : c > 0)
  {
    return false;
  }
  if (slope == 0)
  {
    return std::abs(start) <= stick.HalfLength;
  }
  const auto [enters, leaves] =
    std::minmax({ (-stick.HalfLength - start) / slope, (stick.HalfLength - start) / slope });
  distances[0] = std::max(distances[0], enters);
  distances[1] = std::min(distances[1], leaves);
  return distances[0] <= distances[1];
}
}
