// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwMeshBuilder_h
#define rtwMeshBuilder_h

#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <vector>

class vtkPolyData;

namespace rtw
{
using glm::dvec3;
using Points = std::vector<dvec3>;
using Triangles = std::vector<glm::ivec3>; // indices of points

/// `steps` + 1 values at even distances, the first and the last of which are exact.
std::vector<double> Linspace(double first, double last, int steps);
Points Linspace(const dvec3& first, const dvec3& last, int steps);

/// first, first + step, ... as long as they are less than `end`.
std::vector<double> Arange(double first, double end, double step);

enum class Axis
{
  X,
  Y,
  Z
};

/// Collects triangle patches in double precision. The order of the operations is fixed, to the
/// rounding, because scenes are compared with ones that were made elsewhere.
class MeshBuilder
{
public:
  /// A patch, whose triangles index into its own points.
  void Add(const Points& points, const Triangles& triangles);

  /// A patch of nu x nv quads: point(u, v) with u and v in [0, 1].
  template <class Point>
  void Grid(Point point, int nu, int nv)
  {
    Points points;
    for (const double u : Linspace(0, 1, nu))
    {
      for (const double v : Linspace(0, 1, nv))
      {
        points.push_back(point(u, v));
      }
    }
    this->AddGrid(points, nu, nv);
  }
  void Ground(double x0, double x1, double z0, double z1, int n, double y = 0);

  /// Turned about x by `tilt`, then about y by `turn`.
  void Box(const dvec3& centre, const dvec3& size, double turn = 0, double tilt = 0);
  void Sphere(const dvec3& centre, double radius, int n);

  /// An open cylinder of n sides and m rings, or a cone.
  void Tube(const dvec3& from, const dvec3& to, double radius, int n = 8, int m = 1);
  void Cone(
    const dvec3& from, const dvec3& to, double fromRadius, double toRadius, int n = 8, int m = 1);

  /// An open tube along a path; a radius for each point of it, or one for all.
  void Sweep(const Points& path, const std::vector<double>& radii, int n = 8);

  /// A tube of m sides along n steps of a circle about the axis, or of the first `arc` of it.
  struct Bend
  {
    Axis About = Axis::Y;
    double Arc = 1;
    double Turn = 0; // about y
  };
  void Torus(
    const dvec3& centre, double ringRadius, double tubeRadius, int n, int m, const Bend& bend);
  void Torus(const dvec3& centre, double ringRadius, double tubeRadius, int n, int m)
  {
    this->Torus(centre, ringRadius, tubeRadius, n, m, Bend());
  }

  /// So far, degenerate ones included.
  size_t NumberOfTriangles() const { return this->Cells.size(); }

  /// All points in single precision, and the triangles that have an area.
  vtkSmartPointer<vtkPolyData> Build() const;

private:
  void AddGrid(const Points& points, int nu, int nv);

  Points Vertices;
  Triangles Cells;
};

dvec3 TurnX(const dvec3& p, double angle);
dvec3 TurnY(const dvec3& p, double angle);
dvec3 Unit(const dvec3& v);
}

#endif
