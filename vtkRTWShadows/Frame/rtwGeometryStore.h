// SPDX-License-Identifier: BSD-3-Clause
// All meshes of a scene in a few GPU buffers, so that one indirect draw call draws them all.
#ifndef rtwGeometryStore_h
#define rtwGeometryStore_h

#include "Frame/rtwFrameScene.h"
#include "Frame/rtwMeshData.h"
#include "Frame/rtwRangeAllocator.h"
#include "Frame/rtwThickPrimitives.h"
#include "GL/rtwBuffer.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwResources.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace rtw
{
/// A mesh at a place.
struct Instance
{
  glm::dmat4 ToWorld; ///< from the floats in the buffer
  bool Casts;
  bool Receives;
  bool Hides;
};

/// A cluster at a place, as the culling shaders read it.
struct ClusterDraw
{
  static constexpr std::uint32_t CastsBit = 1;
  static constexpr std::uint32_t ReceivesBit = 2;
  static constexpr std::uint32_t HidesBit = 4;

  std::uint32_t Cluster;
  std::uint32_t Instance;
  std::uint32_t Flags;
  std::uint32_t Unused;
};

/// Lines or vertices of a mesh at a place, as they are seen; they are too few to cull.
struct ThinDraw
{
  Primitive Kind;
  DrawCommand Command; ///< BaseInstance is the instance
};

class GeometryStore
{
public:
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  bool Build() { return this->Thick.Build(); }
  const std::string& GetLog() const { return this->Thick.GetLog(); }
  /// Uploads what is new or changed, drops what has left, and lists what there is to draw. Lines and points cast as wide as that
  /// view shows them.
  void Update(const std::vector<ScenePart>& parts, const View& view);
  /// To be called before anything is cast: turns the lines and points toward where light comes from, a place, or, w being 0, the
  /// way there.
  void Face(const glm::dvec4& light) const;

  const std::vector<Instance>& GetInstances() const { return this->Instances; }
  const std::vector<ThinDraw>& GetThinDraws() const { return this->ThinDraws; }
  /// The least and the greatest product of a direction with any point, both infinite the wrong way round without points.
  /// Looks at the points of those clusters only that can hold either.
  glm::dvec2 Extent(const glm::dvec3& direction) const;
  bool HasHiding() const { return this->Hiding; }
  int GetNumberOfDraws() const { return this->NumberOfDraws; }
  std::size_t GetNumberOfTriangles() const { return this->NumberOfTriangles; }
  const Buffer& GetPoints() const { return this->Points; }
  const Buffer& GetIndices() const { return this->Indices; }
  const Buffer& GetClusters() const { return this->Clusters; }
  const Buffer& GetDraws() const { return this->Draws; }
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  struct Mesh
  {
    std::uint64_t Time = 0;
    std::size_t FirstPoint = 0, FirstIndex = 0, FirstCluster = 0;
    MeshData Data;
    bool Used = false;
  };

  void Upload(Mesh& mesh);
  void Free(const Mesh& mesh);
  void DropUnused();
  void AddThinDraws(const Mesh& mesh, std::uint32_t instance);
  void PlaceThick();
  void UploadThick();
  void AddThick(std::vector<ClusterDraw>& draws);

  Buffer Points, Indices, Clusters, Draws;
  RangeAllocator PointRanges, IndexRanges, ClusterRanges;
  std::unordered_map<vtkPolyData*, Mesh> Meshes;
  std::vector<Instance> Instances;
  std::vector<const Mesh*> InstanceMeshes;
  std::vector<ThinDraw> ThinDraws;
  std::vector<ClusterDraw> Listed;
  /// The lines and points; mutable, as their triangles change with the light that is to be cast
  /// next.
  mutable ThickPrimitives Thick;
  mutable std::optional<glm::dvec4> Faced;
  std::vector<ThickRun> ThickRuns; ///< the runs that were uploaded
  ThickPlace ThickAt{ 0, 0 };
  std::size_t ThickPoints = 0, ThickClusters = 0; ///< the room that lines and points have
  std::optional<std::array<std::size_t, ThickRun::Sides.size()>> ThickIndices; ///< where those of each of ThickRun::Sides stand
  bool Hiding = false;
  int NumberOfDraws = 0;
  std::size_t NumberOfTriangles = 0;
};
}

#endif
