// SPDX-License-Identifier: BSD-3-Clause
// The lines and points of a mesh that are drawn some pixels wide: what casts as rods and balls.
#ifndef rtwThickData_h
#define rtwThickData_h

#include "Frame/rtwThickLook.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPolyData;

namespace rtw
{
/// A line from point to point; a single point is one of no length, joined at both ends.
struct ThickSegment
{
  /// Set where another line goes on, so that the end is round; elsewhere it is cut off.
  static constexpr std::uint32_t JoinedBit = 1u << 31;

  std::uint32_t Start;
  std::uint32_t End;

  static std::uint32_t Point(std::uint32_t end) { return end & ~JoinedBit; }
};

/// No more segments than a cluster holds, and their bounds without any thickness.
struct ThickBlock
{
  static constexpr std::size_t MostSegments = 64;

  glm::vec3 Low;
  glm::vec3 High;
  std::uint32_t First;
  std::uint32_t Count;
};

struct ThickData
{
  glm::dvec3 Centre{ 0 }; ///< what was taken off each point before it became a float
  std::vector<glm::vec3> Points;
  /// Lines, then points; each sorted by place.
  std::vector<ThickSegment> Segments;
  std::vector<ThickBlock> Lines;
  std::vector<ThickBlock> Balls;

  bool IsEmpty() const { return this->Segments.empty(); }
};

/// What is drawn of a mesh by lines and points; cells with points that don't exist or aren't finite are left out.
ThickData BuildThickData(vtkPolyData* data, ThickLook::Shape shape, bool allPoints);
}

#endif
