// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwMeshData.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace
{
using Corners = std::array<glm::vec3, 3>;

vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<glm::dvec3>& points)
{
  vtkNew<vtkPoints> data;
  data->SetDataTypeToDouble();
  for (const glm::dvec3& p : points)
  {
    data->InsertNextPoint(p.x, p.y, p.z);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(data);
  mesh->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  return mesh;
}

void AddCell(vtkCellArray* cells, std::vector<vtkIdType> ids)
{
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

// Triangles of very different sizes.
vtkSmartPointer<vtkPolyData> MakeRandomMesh(int triangles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-10, 10), decade(-3, 1), unit(-1, 1);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < triangles; ++i)
  {
    const glm::dvec3 centre(place(random), place(random), place(random));
    const double size = std::pow(10, decade(random));
    for (int k = 0; k < 3; ++k)
    {
      points.push_back(centre + size * glm::dvec3(unit(random), unit(random), unit(random)));
    }
  }
  auto mesh = MakeMesh(points);
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    AddCell(mesh->GetPolys(), { 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return mesh;
}

Corners CornersOf(const rtw::MeshData& mesh, std::uint32_t index)
{
  return { mesh.Points[mesh.Indices[index]], mesh.Points[mesh.Indices[index + 1]],
    mesh.Points[mesh.Indices[index + 2]] };
}

float ExtentOf(const Corners& c)
{
  const glm::vec3 size =
    glm::max(c[0], glm::max(c[1], c[2])) - glm::min(c[0], glm::min(c[1], c[2]));
  return std::max({ size.x, size.y, size.z });
}

double AreaOf(const rtw::MeshData& mesh)
{
  double area = 0;
  for (std::uint32_t i = 0; i < mesh.GetTriangleIndices(); i += 3)
  {
    const Corners c = CornersOf(mesh, i);
    area += 0.5 * glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
  }
  return area;
}

TEST(MeshData, ClustersHoldEachTriangleOnce)
{
  const auto source = MakeRandomMesh(5000);
  const rtw::MeshData mesh = rtw::BuildMeshData(source);
  EXPECT_EQ(mesh.GetTriangleIndices(), 15000u);
  EXPECT_EQ(mesh.Points.size(), 15000u);
  std::uint32_t next = 0;
  for (const rtw::MeshCluster& cluster : mesh.Clusters)
  {
    EXPECT_EQ(cluster.FirstIndex, next);
    const std::uint32_t count = cluster.ClassEnd.back();
    EXPECT_LE(count, 3 * rtw::MeshCluster::MaximumTriangles);
    EXPECT_EQ(count % 3, 0u);
    next += count;
  }
  EXPECT_EQ(next, mesh.GetTriangleIndices());
  // The same triangles as in the input: each has points of its own, so that one point tells which.
  std::set<std::array<float, 3>> seen, wanted;
  for (std::uint32_t i = 0; i < mesh.GetTriangleIndices(); i += 3)
  {
    const glm::vec3 p = CornersOf(mesh, i)[0];
    seen.insert({ p.x, p.y, p.z });
  }
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); i += 3)
  {
    const double* p = source->GetPoint(i);
    const glm::vec3 q(glm::dvec3(p[0], p[1], p[2]) - mesh.Centre);
    wanted.insert({ q.x, q.y, q.z });
  }
  EXPECT_EQ(seen, wanted);
}

TEST(MeshData, ClustersKnowBoundsAndSizes)
{
  const rtw::MeshData mesh = rtw::BuildMeshData(MakeRandomMesh(5000));
  EXPECT_GT(mesh.Clusters.size(), 4u);
  for (const rtw::MeshCluster& cluster : mesh.Clusters)
  {
    float largest = 0;
    for (std::uint32_t i = 0; i < cluster.ClassEnd.back(); i += 3)
    {
      const Corners corners = CornersOf(mesh, cluster.FirstIndex + i);
      for (const glm::vec3& p : corners)
      {
        EXPECT_TRUE(glm::all(glm::lessThanEqual(cluster.Low, p)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(p, cluster.High)));
      }
      const float extent = ExtentOf(corners);
      largest = std::max(largest, extent);
      // Whoever needs all triangles above a size takes those before the end of a class.
      for (int k = 0; k + 1 < rtw::MeshCluster::SizeClasses; ++k)
      {
        if (extent > 1.0001f * cluster.LargestExtent / float(2 << k))
        {
          EXPECT_LT(i, cluster.ClassEnd[k]);
        }
      }
    }
    EXPECT_FLOAT_EQ(cluster.LargestExtent, largest);
    EXPECT_TRUE(std::is_sorted(cluster.ClassEnd.begin(), cluster.ClassEnd.end()));
  }
}

TEST(MeshData, PolygonsAreFans)
{
  // A concave polygon: VTK's mappers draw a fan about its first point, and so do we.
  auto mesh =
    MakeMesh({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 1, 0 }, { 0, 4, 0 }, { 9, 9, 9 } });
  AddCell(mesh->GetPolys(), { 0, 1, 2, 3, 4 });
  const rtw::MeshData data = rtw::BuildMeshData(mesh);
  EXPECT_EQ(data.GetTriangleIndices(), 9u);
  EXPECT_EQ(data.Points.size(), 5u); // not the one that no cell uses
  EXPECT_NEAR(AreaOf(data), 8 + 2 + 4, 1e-5);
}

TEST(MeshData, StripsAreTriangles)
{
  auto mesh = MakeMesh({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 } });
  vtkNew<vtkCellArray> strips;
  AddCell(strips, { 0, 1, 2, 3, 4 });
  mesh->SetStrips(strips);
  const rtw::MeshData data = rtw::BuildMeshData(mesh);
  EXPECT_EQ(data.GetTriangleIndices(), 9u);
  EXPECT_NEAR(AreaOf(data), 1.5, 1e-6);
}

TEST(MeshData, LinesAndVerticesComeLast)
{
  auto mesh = MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } });
  AddCell(mesh->GetPolys(), { 0, 1, 2 });
  vtkNew<vtkCellArray> lines, vertices;
  AddCell(lines, { 0, 1, 2, 3 });
  AddCell(vertices, { 3, 1 });
  mesh->SetLines(lines);
  mesh->SetVerts(vertices);
  const rtw::MeshData data = rtw::BuildMeshData(mesh);
  EXPECT_EQ(data.GetTriangleIndices(), 3u);
  EXPECT_EQ(data.LineIndices, 6u);
  EXPECT_EQ(data.VertexIndices, 2u);
  EXPECT_EQ(data.Indices.size(), 11u);
}

TEST(MeshData, LeavesOutWhatIsNoTriangle)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto mesh =
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { nan, 1, 0 }, { 0, 1, INFINITY } });
  AddCell(mesh->GetPolys(), { 0, 1, 2 });
  AddCell(mesh->GetPolys(), { 0, 1, 3 });
  AddCell(mesh->GetPolys(), { 0, 1, 4 });
  AddCell(mesh->GetPolys(), { 0, 0, 1 });
  AddCell(mesh->GetPolys(), { 0, 1 });
  AddCell(mesh->GetPolys(), { 0, 1, 77 });
  AddCell(mesh->GetPolys(), { 0, 1, -1 });
  vtkNew<vtkCellArray> lines;
  AddCell(lines, { 0, 3 });
  AddCell(lines, { 2, 99 });
  mesh->SetLines(lines);
  const rtw::MeshData data = rtw::BuildMeshData(mesh);
  EXPECT_EQ(data.GetTriangleIndices(), 3u);
  EXPECT_EQ(data.LineIndices, 0u);
  EXPECT_NEAR(AreaOf(data), 0.5, 1e-6);
  for (const glm::vec3& p : data.Points)
  {
    EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  }
}

TEST(MeshData, IsEmptyWithoutCellsOrPoints)
{
  EXPECT_TRUE(rtw::BuildMeshData(nullptr).IsEmpty());
  vtkNew<vtkPolyData> nothing;
  EXPECT_TRUE(rtw::BuildMeshData(nothing).IsEmpty());
  EXPECT_TRUE(rtw::BuildMeshData(MakeMesh({ { 0, 0, 0 } })).IsEmpty());
}

TEST(MeshData, KeepsPrecisionFarFromTheOrigin)
{
  const glm::dvec3 far(1e7, -2e7, 3e7);
  auto mesh = MakeMesh({ far, far + glm::dvec3(1e-3, 0, 0), far + glm::dvec3(0, 1e-3, 0) });
  AddCell(mesh->GetPolys(), { 0, 1, 2 });
  const rtw::MeshData data = rtw::BuildMeshData(mesh);
  EXPECT_NEAR(AreaOf(data), 0.5e-6, 1e-11);
}
}
