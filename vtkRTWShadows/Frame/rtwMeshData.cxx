// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwMeshData.h"

#include "Frame/rtwMeshPoints.h"
#include "Frame/rtwMorton.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rtw
{
namespace
{
using Triangle = std::array<std::uint32_t, 3>;

struct Sortable
{
  std::uint64_t Key;
  std::uint32_t Triangle;
  float Extent;
};

// Octaves of size that share a group of clusters: a ground plane must not stretch the bounds of the leaves over it.
constexpr int OctavesPerGroup = 3;

struct Builder
{
  vtkPolyData* Data;
  MeshData Mesh;
  MeshPoints Input;
  std::vector<Triangle> Triangles;
  std::vector<std::uint32_t> Lines;
  std::vector<std::uint32_t> Vertices;

  explicit Builder(vtkPolyData* data)
    : Data(data)
    , Input(ReadPoints(data))
  {
    this->Mesh.Centre = this->Input.Centre;
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (this->Input.Exists(a) && this->Input.Exists(b) && this->Input.Exists(c) && a != b && b != c && c != a)
    {
      this->Triangles.push_back({ std::uint32_t(a), std::uint32_t(b), std::uint32_t(c) });
    }
  }

  // Makes a fan of a polygon, also of a concave one, as VTK's mappers do.
  void AddFan(vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType k = 2; k < count; ++k)
    {
      this->AddTriangle(ids[0], ids[k - 1], ids[k]);
    }
  }

  void ReadCells()
  {
    ForEachCell(this->Data->GetPolys(),
      [this](vtkIdType count, const vtkIdType* ids) { this->AddFan(count, ids); });
    ForEachCell(this->Data->GetStrips(), [this](vtkIdType count, const vtkIdType* ids) {
      for (vtkIdType k = 2; k < count; ++k)
      {
        this->AddTriangle(ids[k - 2], ids[k - 1], ids[k]);
      }
    });
    ForEachCell(this->Data->GetLines(), [this](vtkIdType count, const vtkIdType* ids) {
      for (vtkIdType k = 1; k < count; ++k)
      {
        if (this->Input.Exists(ids[k - 1]) && this->Input.Exists(ids[k]))
        {
          this->Lines.push_back(std::uint32_t(ids[k - 1]));
          this->Lines.push_back(std::uint32_t(ids[k]));
        }
      }
    });
    ForEachCell(this->Data->GetVerts(), [this](vtkIdType count, const vtkIdType* ids) {
      for (vtkIdType k = 0; k < count; ++k)
      {
        if (this->Input.Exists(ids[k]))
        {
          this->Vertices.push_back(std::uint32_t(ids[k]));
        }
      }
    });
  }

  std::vector<Sortable> SortTriangles() const
  {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const Triangle& t : this->Triangles)
    {
      for (const std::uint32_t id : t)
      {
        low = glm::min(low, this->Input.Points[id]);
        high = glm::max(high, this->Input.Points[id]);
      }
    }
    const glm::vec3 size = high - low;
    const float side = std::max({ size.x, size.y, size.z, std::numeric_limits<float>::min() });
    std::vector<Sortable> order(this->Triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const Triangle& t = this->Triangles[i];
      const glm::vec3 &a = this->Input.Points[t[0]], &b = this->Input.Points[t[1]], &c = this->Input.Points[t[2]];
      const glm::vec3 extents = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
      const float extent = std::max({ extents.x, extents.y, extents.z });
      const int octave = std::clamp(-std::ilogb(std::max(extent / side, 1e-9f)), 0, 30);
      const std::uint64_t group = octave / OctavesPerGroup;
      const std::uint64_t code = MortonCode(((a + b + c) / 3.f - low) / side);
      order[i] = { group << 57 | code, static_cast<std::uint32_t>(i), extent };
    }
    std::sort(order.begin(), order.end(), [](const Sortable& a, const Sortable& b) {
      return a.Key != b.Key ? a.Key < b.Key : a.Triangle < b.Triangle;
    });
    return order;
  }

  void AddCluster(Sortable* begin, Sortable* end)
  {
    MeshCluster cluster;
    cluster.FirstIndex = static_cast<std::uint32_t>(this->Mesh.Indices.size());
    for (const Sortable* s = begin; s != end; ++s)
    {
      cluster.LargestExtent = std::max(cluster.LargestExtent, s->Extent);
    }
    const auto sizeClass = [&](const Sortable& s) {
      const float ratio = s.Extent > 0 ? cluster.LargestExtent / s.Extent : 1e9f;
      return std::clamp(static_cast<int>(std::log2(ratio)), 0, MeshCluster::SizeClasses - 1);
    };
    // Triangles of a class stay in the order of the input: neighbours there tend to share points.
    std::sort(begin, end, [&](const Sortable& a, const Sortable& b) {
      const int x = sizeClass(a), y = sizeClass(b);
      return x != y ? x < y : a.Triangle < b.Triangle;
    });
    cluster.Low = glm::vec3(std::numeric_limits<float>::max());
    cluster.High = -cluster.Low;
    for (const Sortable* s = begin; s != end; ++s)
    {
      for (const std::uint32_t id : this->Triangles[s->Triangle])
      {
        cluster.Low = glm::min(cluster.Low, this->Input.Points[id]);
        cluster.High = glm::max(cluster.High, this->Input.Points[id]);
        this->Mesh.Indices.push_back(id);
      }
      for (int k = sizeClass(*s); k < MeshCluster::SizeClasses; ++k)
      {
        cluster.ClassEnd[k] += 3;
      }
    }
    this->Mesh.Clusters.push_back(cluster);
  }

  void AddClusters()
  {
    std::vector<Sortable> order = this->SortTriangles();
    for (std::size_t begin = 0; begin < order.size();)
    {
      std::size_t end = begin + 1;
      while (end < order.size() && end - begin < MeshCluster::MaximumTriangles &&
        order[end].Key >> 57 == order[begin].Key >> 57)
      {
        ++end;
      }
      this->AddCluster(&order[begin], &order[begin] + (end - begin));
      begin = end;
    }
  }

  // Sorts points by their first use, and drops those that no cell uses.
  void CompactPoints()
  {
    constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> place(this->Input.Points.size(), unused);
    for (std::uint32_t& id : this->Mesh.Indices)
    {
      if (place[id] == unused)
      {
        place[id] = static_cast<std::uint32_t>(this->Mesh.Points.size());
        this->Mesh.Points.push_back(this->Input.Points[id]);
      }
      id = place[id];
    }
  }
};
}

MeshData BuildMeshData(vtkPolyData* data)
{
  if (!data || !data->GetPoints() || data->GetNumberOfCells() == 0)
  {
    return {};
  }
  Builder builder(data);
  builder.ReadCells();
  builder.AddClusters();
  MeshData& mesh = builder.Mesh;
  mesh.LineIndices = static_cast<std::uint32_t>(builder.Lines.size());
  mesh.VertexIndices = static_cast<std::uint32_t>(builder.Vertices.size());
  mesh.Indices.insert(mesh.Indices.end(), builder.Lines.begin(), builder.Lines.end());
  mesh.Indices.insert(mesh.Indices.end(), builder.Vertices.begin(), builder.Vertices.end());
  builder.CompactPoints();
  return std::move(builder.Mesh);
}
}
