// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwGeometry_h
#define rtwGeometry_h

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace rtw
{
using glm::dvec3;

/// What the primitives of one prop have in common.
struct PropTraits
{
  bool IsSeen = true;   // the camera sees it: it is opaque
  bool Receives = true; // shadows fall on it
  bool Casts = true;    // it throws shadows
  bool CullsFront = false;
  bool CullsBack = false;
  std::vector<glm::dvec4> ClippingPlanes; // keeps what has dot(plane, (p, 1)) >= 0
};

struct Triangle
{
  glm::uvec3 Corners; // indices of Geometry::Points
  uint32_t Prop;
};

struct Ball
{
  dvec3 Centre;
  double Radius;
  uint32_t Prop;
};

/// A cylinder with flat ends.
struct Stick
{
  dvec3 Centre;
  dvec3 Axis; // of length one
  double HalfLength;
  double Radius;
  uint32_t Prop;
};

/// Everything in a renderer that has a surface, in world coordinates relative to the camera, so
/// that single precision has its best resolution where the picture needs it.
struct Geometry
{
  dvec3 Origin{ 0 }; // in world coordinates
  std::vector<dvec3> Points;
  std::vector<Triangle> Triangles;
  std::vector<Ball> Balls;
  std::vector<Stick> Sticks;
  std::vector<PropTraits> Props;

  /// The diagonal of the bounding box.
  double Diagonal() const;
};

/// Which primitive: the members of Geometry in their order, and the index there.
enum class Shape : uint32_t
{
  TRIANGLE,
  BALL,
  STICK
};

struct Primitive
{
  Shape Kind = Shape::TRIANGLE;
  uint32_t Index = ~0u;

  bool operator==(const Primitive& other) const
  {
    return this->Kind == other.Kind && this->Index == other.Index;
  }
};

const PropTraits& Traits(const Geometry& geometry, const Primitive& primitive);

struct Ray
{
  dvec3 Origin;
  dvec3 Direction; // of length one
  double Nearest;
  double Farthest;

  dvec3 At(double distance) const { return this->Origin + distance * this->Direction; }
};

/// A point of a surface, and its normal, which may point to either side.
struct SurfacePoint
{
  dvec3 Position;
  dvec3 Normal; // of length one, or not a number on a degenerate triangle
};

/// Where a ray that is known to hit a primitive, at about a distance, meets it.
SurfacePoint Meet(
  const Geometry& geometry, const Primitive& primitive, const Ray& ray, double about);

/// The distances at which a line enters and leaves a solid; false if it misses it.
bool Cross(const Ball& ball, const Ray& ray, double distances[2]);
bool Cross(const Stick& stick, const Ray& ray, double distances[2]);
}

#endif
