// SPDX-License-Identifier: BSD-3-Clause
// Lines and points as casters: rods and balls as wide in the world as the pixels that they are drawn with are there, a flat
// piece of each for the light that it is to face.
#ifndef rtwThickPrimitives_h
#define rtwThickPrimitives_h

#include "Frame/rtwFrameScene.h"
#include "Frame/rtwThickData.h"
#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace rtw
{
struct View;

/// Segments of a group that become one cluster of triangles.
struct ThickRun
{
  /// A half circle is so many pieces, by how many pixels wide it is.
  static constexpr std::array<std::uint32_t, 4> Sides{ 1, 2, 4, 8 };

  std::uint32_t FirstSegment;
  std::uint32_t Segments;
  std::uint32_t Group;
  std::uint32_t Class; ///< index into Sides
  bool IsBalls;

  bool operator==(const ThickRun& other) const;
  std::uint32_t GetPoints() const { return this->Segments * (4 + 2 * Sides[this->Class]); }
  std::uint32_t GetTriangles() const { return this->Segments * 2 * Sides[this->Class]; }
};

/// Places in the store's buffers where lines and points are written.
struct ThickPlace
{
  std::size_t FirstPoint;
  std::size_t FirstCluster;
};

class ThickPrimitives
{
public:
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  bool Build();
  const std::string& GetLog() const { return this->Facing.GetLog(); }
  /// Finds what casts among the parts, as wide as that view shows it.
  void Update(const std::vector<ScenePart>& parts, const View& view);
  bool IsEmpty() const { return this->Runs.empty(); }
  const std::vector<ThickRun>& GetRuns() const { return this->Runs; }
  std::size_t GetNumberOfPoints() const { return this->NumberOfPoints; }
  /// The place of each group's centre in the world.
  std::vector<glm::dvec3> GetCentres() const;
  /// The triangles of a run's segments, by its points.
  static std::vector<std::uint32_t> IndicesOf(std::uint32_t sides);
  /// The least and the greatest product of a direction with any point, both infinite the wrong way round without any.
  glm::dvec2 Extent(const glm::dvec3& direction) const;
  /// Makes all face where light comes from: a place, or, w being 0, the way there.
  void Face(const glm::dvec4& light, const ThickPlace& place, const Buffer& points,
    const Buffer& clusters);
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  using Key = std::tuple<vtkPolyData*, ThickLook::Shape, bool>;
  struct Mesh
  {
    std::uint64_t Time = 0;
    ThickData Data;
    std::uint32_t FirstSegment = 0;
    bool Used = false;
  };
  /// A mesh at a place.
  struct Group
  {
    const Mesh* Of;
    glm::dmat3 ToWorld;
    glm::dvec3 Centre;
    glm::dvec4 Distance; ///< along the view, from the centre on
    glm::dvec2 Radii;    ///< radii of lines and points per unit of that distance
  };

  std::array<Buffer*, 4> Buffers();
  Mesh& Find(const ScenePart& part);
  void AddRuns(const Mesh& mesh, const ThickLook& look);
  void DropUnused();
  void Upload();
  void PlaceRuns(const ThickPlace& place);
  double GreatestOf(const Group& group, const glm::dvec3& direction, double least) const;

  Program Facing;
  Buffer Points, Segments, Groups, Runnings;
  std::map<Key, Mesh> Meshes;
  std::vector<Group> Placed;
  std::vector<ThickRun> Runs;
  std::size_t NumberOfPoints = 0;
  bool HasPlaced = false;   ///< the runs, since the last update
  bool Changed = true; ///< any mesh, since the last upload
};
}

#endif
