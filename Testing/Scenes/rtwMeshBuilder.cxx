// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMeshBuilder.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>

namespace rtw
{
namespace
{
const double PI = std::acos(-1.0);

// The derivative along a path, by central differences and one-sided ones at the ends.
Points Tangents(const Points& path)
{
  const size_t last = path.size() - 1;
  Points tangents(path.size());
  tangents[0] = path[1] - path[0];
  tangents[last] = path[last] - path[last - 1];
  for (size_t i = 1; i < last; ++i)
  {
    tangents[i] = (path[i + 1] - path[i - 1]) / 2.0;
  }
  for (dvec3& tangent : tangents)
  {
    tangent = Unit(tangent);
  }
  return tangents;
}

// The coordinate axis that is least along a direction.
dvec3 AxisAcross(const dvec3& direction)
{
  int least = 0;
  for (int i = 1; i < 3; ++i)
  {
    if (std::abs(direction[i]) < std::abs(direction[least]))
    {
      least = i;
    }
  }
  dvec3 axis(0);
  axis[least] = 1;
  return axis;
}
}

std::vector<double> Linspace(double first, double last, int steps)
{
  const double step = (last - first) / steps;
  std::vector<double> values;
  for (int i = 0; i < steps; ++i)
  {
    // A step of zero, from values that are too near to differ, must still reach the last one.
    values.push_back((step == 0 ? i / double(steps) * (last - first) : i * step) + first);
  }
  values.push_back(last);
  return values;
}

Points Linspace(const dvec3& first, const dvec3& last, int steps)
{
  const dvec3 delta = last - first, step = delta / double(steps);
  const bool stands = step.x == 0 || step.y == 0 || step.z == 0;
  Points values;
  for (int i = 0; i < steps; ++i)
  {
    values.push_back((stands ? i / double(steps) * delta : double(i) * step) + first);
  }
  values.push_back(last);
  return values;
}

std::vector<double> Arange(double first, double end, double step)
{
  const int count = int(std::ceil((end - first) / step));
  const double exactStep = (first + step) - first;
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(first + i * exactStep);
  }
  return values;
}

dvec3 TurnX(const dvec3& p, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return { p.x, c * p.y - s * p.z, s * p.y + c * p.z };
}

dvec3 TurnY(const dvec3& p, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return { c * p.x + s * p.z, p.y, -s * p.x + c * p.z };
}

dvec3 Unit(const dvec3& v)
{
  return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

void MeshBuilder::Add(const Points& points, const Triangles& triangles)
{
  const int first = int(this->Vertices.size());
  this->Vertices.insert(this->Vertices.end(), points.begin(), points.end());
  for (const glm::ivec3& triangle : triangles)
  {
    this->Cells.push_back(triangle + first);
  }
}

void MeshBuilder::AddGrid(const Points& points, int nu, int nv)
{
  const int w = nv + 1;
  Triangles lower, upper;
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      const int k = i * w + j;
      lower.emplace_back(k, k + 1, k + w);
      upper.emplace_back(k + w, k + 1, k + w + 1);
    }
  }
  lower.insert(lower.end(), upper.begin(), upper.end());
  this->Add(points, lower);
}

void MeshBuilder::Ground(double x0, double x1, double z0, double z1, int n, double y)
{
  this->Grid(
    [=](double u, double v) { return dvec3(x0 + (x1 - x0) * u, y, z0 + (z1 - z0) * v); }, n, n);
}

void MeshBuilder::Box(const dvec3& centre, const dvec3& size, double turn, double tilt)
{
  Points corners;
  for (const double x : { -0.5, 0.5 })
  {
    for (const double y : { -0.5, 0.5 })
    {
      for (const double z : { -0.5, 0.5 })
      {
        corners.push_back(TurnY(TurnX(dvec3(x, y, z) * size, tilt), turn) + centre);
      }
    }
  }
  const int quads[6][4] = { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 },
    { 0, 2, 6, 4 }, { 1, 5, 7, 3 } };
  Triangles triangles;
  for (const auto& q : quads)
  {
    triangles.emplace_back(q[0], q[1], q[2]);
    triangles.emplace_back(q[0], q[2], q[3]);
  }
  this->Add(corners, triangles);
}

void MeshBuilder::Sphere(const dvec3& centre, double radius, int n)
{
  const auto point = [&](double u, double v) {
    const double across = radius * std::sin(PI * u);
    return dvec3(centre.x + across * std::cos(2 * PI * v), centre.y + radius * std::cos(PI * u),
      centre.z - across * std::sin(2 * PI * v));
  };
  this->Grid(point, n, 2 * n);
}

void MeshBuilder::Tube(const dvec3& from, const dvec3& to, double radius, int n, int m)
{
  this->Cone(from, to, radius, radius, n, m);
}

void MeshBuilder::Cone(
  const dvec3& from, const dvec3& to, double fromRadius, double toRadius, int n, int m)
{
  this->Sweep(Linspace(from, to, m), Linspace(fromRadius, toRadius, m), n);
}

void MeshBuilder::Sweep(const Points& path, const std::vector<double>& radii, int n)
{
  const Points tangents = Tangents(path);
  const dvec3 reference = AxisAcross(tangents[0]);
  const int length = int(path.size());
  Points points;
  for (int i = 0; i < length; ++i)
  {
    const dvec3 a = Unit(glm::cross(tangents[i], reference)), b = glm::cross(tangents[i], a);
    const double radius = radii.size() == 1 ? radii[0] : radii[i];
    for (int j = 0; j < n; ++j)
    {
      const double angle = j * (2 * PI / n);
      points.push_back(path[i] + (a * std::cos(angle) + b * std::sin(angle)) * radius);
    }
  }
  Triangles lower, upper;
  for (int i = 0; i + 1 < length; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const int k = i * n + j, l = i * n + (j + 1) % n;
      lower.emplace_back(k, l, k + n);
      upper.emplace_back(k + n, l, l + n);
    }
  }
  lower.insert(lower.end(), upper.begin(), upper.end());
  this->Add(points, lower);
}

void MeshBuilder::Torus(
  const dvec3& centre, double ringRadius, double tubeRadius, int n, int m, const Bend& bend)
{
  Points path;
  for (const double angle : Linspace(0, 2 * PI * bend.Arc, n))
  {
    const double c = std::cos(angle), s = std::sin(angle);
    const dvec3 ring = bend.About == Axis::X ? dvec3(0, s, c)
      : bend.About == Axis::Y                ? dvec3(c, 0, s)
                                             : dvec3(c, s, 0);
    path.push_back(TurnY(ring, bend.Turn) * ringRadius + centre);
  }
  this->Sweep(path, { tubeRadius }, m);
}

vtkSmartPointer<vtkPolyData> MeshBuilder::Build() const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(vtkIdType(this->Vertices.size()));
  for (size_t i = 0; i < this->Vertices.size(); ++i)
  {
    const dvec3& p = this->Vertices[i];
    points->SetPoint(vtkIdType(i), p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(vtkIdType(this->Cells.size()), 3 * vtkIdType(this->Cells.size()));
  for (const glm::ivec3& t : this->Cells)
  {
    const glm::vec3 a(this->Vertices[t.x]), b(this->Vertices[t.y]), c(this->Vertices[t.z]);
    if (glm::length(glm::cross(dvec3(b - a), dvec3(c - a))) > 1e-12)
    {
      const vtkIdType ids[3] = { t.x, t.y, t.z };
      cells->InsertNextCell(3, ids);
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}
}
