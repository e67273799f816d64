// SPDX-License-Identifier: BSD-3-Clause
#include "rtwGeometryStore.h"

#include "rtwSceneActor.h"

#include "vtkPolyData.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cstring>

namespace rtw
{
namespace
{
// As the shaders declare it, with the rules of std430.
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

void GeometryStore::Upload(Mesh& mesh, const MeshData& data)
{
  mesh.Centre = data.Centre;
  mesh.Points = data.Points.size();
  mesh.Indices = data.Indices.size();
  mesh.Clusters = data.Clusters.size();
  mesh.LineIndices = data.LineIndices;
  mesh.VertexIndices = data.VertexIndices;
  mesh.TriangleIndices =
    static_cast<std::uint32_t>(mesh.Indices) - data.LineIndices - data.VertexIndices;
  mesh.FirstPoint = this->PointRanges.Allocate(mesh.Points);
  mesh.FirstIndex = this->IndexRanges.Allocate(mesh.Indices);
  mesh.FirstCluster = this->ClusterRanges.Allocate(mesh.Clusters);
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
  this->Points.Write(
    mesh.FirstPoint * sizeof(glm::vec3), data.Points.data(), mesh.Points * sizeof(glm::vec3));
  this->Indices.Write(mesh.FirstIndex * sizeof(std::uint32_t), data.Indices.data(),
    mesh.Indices * sizeof(std::uint32_t));
  this->Clusters.Write(mesh.FirstCluster * sizeof(GpuCluster), clusters.data(),
    clusters.size() * sizeof(GpuCluster));
}

void GeometryStore::Free(const Mesh& mesh)
{
  this->PointRanges.Free(mesh.FirstPoint, mesh.Points);
  this->IndexRanges.Free(mesh.FirstIndex, mesh.Indices);
  this->ClusterRanges.Free(mesh.FirstCluster, mesh.Clusters);
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
  const auto base = static_cast<std::uint32_t>(mesh.FirstPoint);
  const std::uint32_t lines = static_cast<std::uint32_t>(mesh.FirstIndex) + mesh.TriangleIndices;
  if (mesh.LineIndices > 0)
  {
    this->ThinDraws.push_back({ Primitive::Lines, { mesh.LineIndices, 1, lines, base, instance } });
  }
  if (mesh.VertexIndices > 0)
  {
    this->ThinDraws.push_back({ Primitive::Points,
      { mesh.VertexIndices, 1, lines + mesh.LineIndices, base, instance } });
  }
}

void GeometryStore::Update(const std::vector<ScenePart>& parts)
{
  std::vector<ClusterDraw> draws;
  this->Instances.clear();
  this->ThinDraws.clear();
  this->NumberOfTriangles = 0;
  for (const ScenePart& part : parts)
  {
    Mesh& mesh = this->Meshes[part.Data];
    const std::uint64_t time = MeshTime(part.Data);
    if (mesh.Time != time)
    {
      this->Free(mesh);
      this->Upload(mesh, BuildMeshData(part.Data));
      mesh.Time = time;
    }
    mesh.Used = true;
    const auto instance = static_cast<std::uint32_t>(this->Instances.size());
    this->Instances.push_back(
      { part.ToWorld * glm::translate(glm::dmat4(1), mesh.Centre), part.Casts, part.Receives });
    const std::uint32_t flags = (part.Casts ? ClusterDraw::CastsBit : 0) |
      (part.Receives ? ClusterDraw::ReceivesBit : 0);
    for (std::size_t i = 0; i < mesh.Clusters; ++i)
    {
      draws.push_back({ static_cast<std::uint32_t>(mesh.FirstCluster + i), instance, flags, 0 });
    }
    this->AddThinDraws(mesh, instance);
    this->NumberOfTriangles += mesh.TriangleIndices / 3;
  }
  this->DropUnused();
  this->NumberOfDraws = static_cast<int>(draws.size());
  const bool same = draws.size() == this->Listed.size() &&
    std::memcmp(draws.data(), this->Listed.data(), draws.size() * sizeof(ClusterDraw)) == 0;
  if (!same && !draws.empty())
  {
    this->Draws.Assign(draws);
    this->Listed = std::move(draws);
  }
}

std::size_t GeometryStore::GetMemory() const
{
  return this->Points.GetSize() + this->Indices.GetSize() + this->Clusters.GetSize() +
    this->Draws.GetSize();
}

void GeometryStore::Release()
{
  for (Buffer* buffer : { &this->Points, &this->Indices, &this->Clusters, &this->Draws })
  {
    buffer->Release();
  }
  this->Abandon();
}

void GeometryStore::Abandon()
{
  for (Buffer* buffer : { &this->Points, &this->Indices, &this->Clusters, &this->Draws })
  {
    buffer->Abandon();
  }
  this->PointRanges.Clear();
  this->IndexRanges.Clear();
  this->ClusterRanges.Clear();
  this->Meshes.clear();
  this->Instances.clear();
  this->ThinDraws.clear();
  this->Listed.clear();
  this->NumberOfDraws = 0;
}
}
