// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwGeometryStore.h"

#include "Frame/rtwSceneActor.h"

#include "vtkPolyData.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

namespace rtw
{
namespace
{
// A cluster as the shaders declare it (rtwClusterDraw.glsl), by the rules of std430.
struct GpuCluster
{
  glm::vec3 Low;
  float LargestExtent;
  glm::vec3 High;
  std::uint32_t FirstIndex;
  std::uint32_t BaseVertex;
  std::uint32_t Unused[3];
  std::uint32_t ClassEnd[MeshCluster::SizeClasses];
};
static_assert(sizeof(GpuCluster) == 80, "the shaders read it with this stride");
}

void GeometryStore::Upload(Mesh& mesh)
{
  const MeshData& data = mesh.Data;
  mesh.FirstPoint = this->PointRanges.Allocate(data.Points.size());
  mesh.FirstIndex = this->IndexRanges.Allocate(data.Indices.size());
  mesh.FirstCluster = this->ClusterRanges.Allocate(data.Clusters.size());
  this->Points.Reserve(this->PointRanges.GetEnd() * sizeof(glm::vec3), true);
  this->Indices.Reserve(this->IndexRanges.GetEnd() * sizeof(std::uint32_t), true);
  this->Clusters.Reserve(this->ClusterRanges.GetEnd() * sizeof(GpuCluster), true);
  std::vector<GpuCluster> clusters;
  for (const MeshCluster& cluster : data.Clusters)
  {
    GpuCluster gpu{ cluster.Low, cluster.LargestExtent, cluster.High,
      static_cast<std::uint32_t>(mesh.FirstIndex) + cluster.FirstIndex,
      static_cast<std::uint32_t>(mesh.FirstPoint), {}, {} };
    std::memcpy(gpu.ClassEnd, cluster.ClassEnd.data(), sizeof(gpu.ClassEnd));
    clusters.push_back(gpu);
  }
  this->Points.Write(mesh.FirstPoint * sizeof(glm::vec3), data.Points.data(),
    data.Points.size() * sizeof(glm::vec3));
  this->Indices.Write(mesh.FirstIndex * sizeof(std::uint32_t), data.Indices.data(),
    data.Indices.size() * sizeof(std::uint32_t));
  this->Clusters.Write(mesh.FirstCluster * sizeof(GpuCluster), clusters.data(),
    clusters.size() * sizeof(GpuCluster));
}

void GeometryStore::Free(const Mesh& mesh)
{
  this->PointRanges.Free(mesh.FirstPoint, mesh.Data.Points.size());
  this->IndexRanges.Free(mesh.FirstIndex, mesh.Data.Indices.size());
  this->ClusterRanges.Free(mesh.FirstCluster, mesh.Data.Clusters.size());
}

void GeometryStore::DropUnused()
{
  for (auto at = this->Meshes.begin(); at != this->Meshes.end();)
  {
    if (at->second.Used)
    {
      at->second.Used = false;
      ++at;
    }
    else
    {
      this->Free(at->second);
      at = this->Meshes.erase(at);
    }
  }
}

void GeometryStore::AddThinDraws(const Mesh& mesh, std::uint32_t instance)
{
  const MeshData& data = mesh.Data;
  const auto base = static_cast<std::uint32_t>(mesh.FirstPoint);
  const std::uint32_t lines =
    static_cast<std::uint32_t>(mesh.FirstIndex) + data.GetTriangleIndices();
  if (data.LineIndices > 0)
  {
    this->ThinDraws.push_back({ Primitive::Lines, { data.LineIndices, 1, lines, base, instance } });
  }
  if (data.VertexIndices > 0)
  {
    this->ThinDraws.push_back({ Primitive::Points,
      { data.VertexIndices, 1, lines + data.LineIndices, base, instance } });
  }
}

// Makes room for the lines and points that the GPU writes.
void GeometryStore::PlaceThick()
{
  const std::size_t points = this->Thick.GetNumberOfPoints();
  const std::size_t clusters = this->Thick.GetRuns().size();
  if (points != this->ThickPoints || clusters != this->ThickClusters)
  {
    this->PointRanges.Free(this->ThickAt.FirstPoint, this->ThickPoints);
    this->ClusterRanges.Free(this->ThickAt.FirstCluster, this->ThickClusters);
    this->ThickAt = { this->PointRanges.Allocate(points), this->ClusterRanges.Allocate(clusters) };
    this->ThickPoints = points;
    this->ThickClusters = clusters;
    this->Points.Reserve(this->PointRanges.GetEnd() * sizeof(glm::vec3), true);
    this->Clusters.Reserve(this->ClusterRanges.GetEnd() * sizeof(GpuCluster), true);
    this->ThickRuns.clear();
  }
  if (!this->ThickIndices && clusters > 0)
  {
    this->ThickIndices.emplace();
    for (std::size_t k = 0; k < ThickRun::Sides.size(); ++k)
    {
      const std::vector<std::uint32_t> indices = ThickPrimitives::IndicesOf(ThickRun::Sides[k]);
      const std::size_t first = this->IndexRanges.Allocate(indices.size());
      this->Indices.Reserve(this->IndexRanges.GetEnd() * sizeof(std::uint32_t), true);
      this->Indices.Write(first * sizeof(std::uint32_t), indices.data(),
        indices.size() * sizeof(std::uint32_t));
      (*this->ThickIndices)[k] = first;
    }
  }
}

// Uploads lines and points; the GPU finds for each light where their triangles lie.
void GeometryStore::UploadThick()
{
  const std::vector<ThickRun>& runs = this->Thick.GetRuns();
  if (runs == this->ThickRuns)
  {
    return;
  }
  this->ThickRuns = runs;
  std::vector<GpuCluster> clusters;
  auto point = static_cast<std::uint32_t>(this->ThickAt.FirstPoint);
  for (const ThickRun& run : runs)
  {
    GpuCluster cluster{};
    cluster.FirstIndex = static_cast<std::uint32_t>((*this->ThickIndices)[run.Class]);
    cluster.BaseVertex = point;
    std::fill(std::begin(cluster.ClassEnd), std::end(cluster.ClassEnd), 3 * run.GetTriangles());
    clusters.push_back(cluster);
    point += run.GetPoints();
  }
  this->Clusters.Write(this->ThickAt.FirstCluster * sizeof(GpuCluster), clusters.data(),
    clusters.size() * sizeof(GpuCluster));
}

void GeometryStore::AddThick(std::vector<ClusterDraw>& draws)
{
  this->PlaceThick();
  this->UploadThick();
  const auto instance = static_cast<std::uint32_t>(this->Instances.size());
  for (const glm::dvec3& centre : this->Thick.GetCentres())
  {
    this->Instances.push_back({ glm::translate(glm::dmat4(1), centre), true, false, false });
  }
  const std::vector<ThickRun>& runs = this->Thick.GetRuns();
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    draws.push_back({ static_cast<std::uint32_t>(this->ThickAt.FirstCluster + i),
      instance + runs[i].Group, ClusterDraw::CastsBit, 0 });
    this->NumberOfTriangles += runs[i].GetTriangles();
  }
}

void GeometryStore::Face(const glm::dvec4& light) const
{
  if (!this->Thick.IsEmpty() && this->Faced != light)
  {
    this->Faced = light;
    this->Thick.Face(light, this->ThickAt, this->Points, this->Clusters);
  }
}

void GeometryStore::Update(const std::vector<ScenePart>& parts, const View& view)
{
  std::vector<ClusterDraw> draws;
  this->Instances.clear();
  this->InstanceMeshes.clear();
  this->ThinDraws.clear();
  this->NumberOfTriangles = 0;
  this->Hiding = false;
  this->Faced.reset();
  this->Thick.Update(parts, view);
  for (const ScenePart& part : parts)
  {
    if (part.Look.Drawn != ThickLook::Shape::Surface)
    {
      continue;
    }
    Mesh& mesh = this->Meshes[part.Data];
    const std::uint64_t time = MeshTime(part.Data);
    if (mesh.Time != time)
    {
      this->Free(mesh);
      mesh.Data = BuildMeshData(part.Data);
      this->Upload(mesh);
      mesh.Time = time;
    }
    mesh.Used = true;
    const auto instance = static_cast<std::uint32_t>(this->Instances.size());
    this->Instances.push_back(
      { part.ToWorld * glm::translate(glm::dmat4(1), mesh.Data.Centre), part.Casts, part.Receives,
        part.Hides });
    this->InstanceMeshes.push_back(&mesh);
    const std::uint32_t flags = (part.Casts ? ClusterDraw::CastsBit : 0) |
      (part.Receives ? ClusterDraw::ReceivesBit : 0) | (part.Hides ? ClusterDraw::HidesBit : 0);
    this->Hiding = this->Hiding || part.Hides;
    for (std::size_t i = 0; i < mesh.Data.Clusters.size(); ++i)
    {
      draws.push_back({ static_cast<std::uint32_t>(mesh.FirstCluster + i), instance, flags, 0 });
    }
    this->AddThinDraws(mesh, instance);
    this->NumberOfTriangles += mesh.Data.GetTriangleIndices() / 3;
  }
  this->DropUnused();
  this->AddThick(draws);
  this->NumberOfDraws = static_cast<int>(draws.size());
  const bool same = draws.size() == this->Listed.size() &&
    std::memcmp(draws.data(), this->Listed.data(), draws.size() * sizeof(ClusterDraw)) == 0;
  if (!same && !draws.empty())
  {
    this->Draws.Assign(draws);
    this->Listed = std::move(draws);
  }
}

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The greatest product of a direction with the points of a range of indices.
double Greatest(const MeshData& data, std::size_t first, std::size_t end, const glm::dvec3& direction)
{
  double greatest = -Infinity;
  for (std::size_t i = first; i < end; ++i)
  {
    greatest = std::max(greatest, glm::dot(glm::dvec3(data.Points[data.Indices[i]]), direction));
  }
  return greatest;
}

// The greatest product of a direction with the points of a mesh, or `least` if none is greater.
double GreatestOf(const MeshData& data, const glm::dvec3& direction, double least)
{
  for (const MeshCluster& cluster : data.Clusters)
  {
    const glm::dvec3 farthest(direction.x > 0 ? cluster.High.x : cluster.Low.x,
      direction.y > 0 ? cluster.High.y : cluster.Low.y,
      direction.z > 0 ? cluster.High.z : cluster.Low.z);
    if (glm::dot(farthest, direction) > least)
    {
      const std::size_t end = cluster.FirstIndex + cluster.ClassEnd.back();
      least = std::max(least, Greatest(data, cluster.FirstIndex, end, direction));
    }
  }
  return std::max(
    least, Greatest(data, data.GetTriangleIndices(), data.Indices.size(), direction));
}
}

glm::dvec2 GeometryStore::Extent(const glm::dvec3& direction) const
{
  const glm::dvec2 thick = this->Thick.Extent(direction);
  double least = thick.x, greatest = thick.y;
  for (std::size_t i = 0; i < this->InstanceMeshes.size(); ++i)
  {
    const glm::dmat4& toWorld = this->Instances[i].ToWorld;
    const glm::dvec3 local = glm::transpose(glm::dmat3(toWorld)) * direction;
    const double offset = glm::dot(glm::dvec3(toWorld[3]), direction);
    const MeshData& data = this->InstanceMeshes[i]->Data;
    greatest = offset + GreatestOf(data, local, greatest - offset);
    least = offset - GreatestOf(data, -local, offset - least);
  }
  return { least, greatest };
}

std::size_t GeometryStore::GetMemory() const
{
  return this->Thick.GetMemory() + this->Points.GetSize() + this->Indices.GetSize() + this->Clusters.GetSize() +
    this->Draws.GetSize();
}

void GeometryStore::Dispose(Disposal dispose)
{
  dispose(this->Points, this->Indices, this->Clusters, this->Draws, this->Thick);
  this->PointRanges.Clear();
  this->IndexRanges.Clear();
  this->ClusterRanges.Clear();
  this->Meshes.clear();
  this->Instances.clear();
  this->InstanceMeshes.clear();
  this->ThinDraws.clear();
  this->Listed.clear();
  this->Faced.reset();
  this->ThickRuns.clear();
  this->ThickIndices.reset();
  this->ThickPoints = this->ThickClusters = 0;
  this->NumberOfDraws = 0;
}
}
