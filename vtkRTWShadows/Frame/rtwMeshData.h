// SPDX-License-Identifier: BSD-3-Clause
// A polygonal mesh in the order in which the light and view passes want it.
//
// Triangles are grouped into clusters that are small in space, so that what a pass doesn't need is skipped, and in
// each cluster large triangles come before small ones, so that those on which a warp bends are a range at its start.
#ifndef rtwMeshData_h
#define rtwMeshData_h

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace rtw
{
struct MeshCluster
{
  static constexpr int SizeClasses = 8;
  static constexpr std::size_t MaximumTriangles = 256;

  glm::vec3 Low{ 0 }; ///< bounds, relative to the mesh's centre
  glm::vec3 High{ 0 };
  float LargestExtent = 0; ///< the largest extent of any triangle's bounds along an axis
  std::uint32_t FirstIndex = 0;
  /// Indices of triangles whose extent is above LargestExtent / 2^(k + 1), and of all for the last k.
  std::array<std::uint32_t, SizeClasses> ClassEnd{};
};

struct MeshData
{
  glm::dvec3 Centre{ 0 }; ///< what was taken off each point before it became a float
  std::vector<glm::vec3> Points;
  std::vector<std::uint32_t> Indices; ///< of the clusters' triangles, then of lines, then of vertices
  std::vector<MeshCluster> Clusters;
  std::uint32_t LineIndices = 0;
  std::uint32_t VertexIndices = 0;

  std::uint32_t GetTriangleIndices() const
  {
    return static_cast<std::uint32_t>(this->Indices.size()) - this->LineIndices -
      this->VertexIndices;
  }
  bool IsEmpty() const { return this->Indices.empty(); }
};

/// Polygons become fans, strips triangles; cells with points that don't exist or aren't finite are left out.
MeshData BuildMeshData(vtkPolyData* data);
}

#endif
