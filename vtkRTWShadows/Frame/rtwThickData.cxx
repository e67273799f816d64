// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwThickData.h"

#include "Frame/rtwMeshPoints.h"
#include "Frame/rtwMorton.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rtw
{
namespace
{
struct Builder
{
  vtkPolyData* Data;
  MeshPoints Input;
  ThickData Result;
  std::vector<std::uint64_t> Edges; ///< each by its points, the lesser first
  std::vector<bool> IsBall;         ///< a point

  explicit Builder(vtkPolyData* data)
    : Data(data)
    , Input(ReadPoints(data))
    , IsBall(Input.Points.size(), false)
  {
    this->Result.Centre = this->Input.Centre;
  }

  void AddBalls(vtkCellArray* cells)
  {
    ForEachCell(cells, [this](vtkIdType count, const vtkIdType* ids) {
      for (vtkIdType k = 0; k < count; ++k)
      {
        if (this->Input.Exists(ids[k]))
        {
          this->IsBall[ids[k]] = true;
        }
      }
    });
  }

  void AddLine(vtkIdType count, const vtkIdType* ids)
  {
    const bool closed = count > 2 && ids[0] == ids[count - 1];
    for (vtkIdType k = 1; k < count; ++k)
    {
      if (this->Input.Exists(ids[k - 1]) && this->Input.Exists(ids[k]))
      {
        const bool before = k > 1 || closed, after = k + 1 < count || closed;
        this->Result.Segments.push_back(
          { std::uint32_t(ids[k - 1]) | (before ? ThickSegment::JoinedBit : 0),
            std::uint32_t(ids[k]) | (after ? ThickSegment::JoinedBit : 0) });
      }
    }
  }

  void AddEdge(vtkIdType a, vtkIdType b)
  {
    if (a != b && this->Input.Exists(a) && this->Input.Exists(b))
    {
      this->Edges.push_back(std::uint64_t(std::min(a, b)) << 32 | std::uint64_t(std::max(a, b)));
    }
  }

  // Adds each edge once: most edges belong to two cells.
  void AddEdges()
  {
    ForEachCell(this->Data->GetPolys(), [this](vtkIdType count, const vtkIdType* ids) {
      for (vtkIdType k = 0; k < count; ++k)
      {
        this->AddEdge(ids[k], ids[(k + 1) % count]);
      }
    });
    ForEachCell(this->Data->GetStrips(), [this](vtkIdType count, const vtkIdType* ids) {
      for (vtkIdType k = 1; k < count; ++k)
      {
        this->AddEdge(ids[k - 1], ids[k]);
        if (k > 1)
        {
          this->AddEdge(ids[k - 2], ids[k]);
        }
      }
    });
    std::sort(this->Edges.begin(), this->Edges.end());
    this->Edges.erase(
      std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
    for (const std::uint64_t edge : this->Edges)
    {
      this->Result.Segments.push_back({ std::uint32_t(edge >> 32) | ThickSegment::JoinedBit,
        std::uint32_t(edge) | ThickSegment::JoinedBit });
    }
  }

  void ReadCells(ThickLook::Shape shape, bool allPoints)
  {
    this->AddBalls(this->Data->GetVerts());
    if (allPoints || shape == ThickLook::Shape::Points)
    {
      for (vtkCellArray* cells :
        { this->Data->GetLines(), this->Data->GetPolys(), this->Data->GetStrips() })
      {
        this->AddBalls(cells);
      }
    }
    if (shape != ThickLook::Shape::Points)
    {
      ForEachCell(this->Data->GetLines(),
        [this](vtkIdType count, const vtkIdType* ids) { this->AddLine(count, ids); });
    }
    if (shape == ThickLook::Shape::Edges)
    {
      this->AddEdges();
    }
  }

  glm::vec3 PointOf(std::uint32_t end) const
  {
    return this->Input.Points[ThickSegment::Point(end)];
  }

  void Sort(std::size_t first)
  {
    std::vector<ThickSegment>& all = this->Result.Segments;
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (std::size_t i = first; i < all.size(); ++i)
    {
      for (const std::uint32_t end : { all[i].Start, all[i].End })
      {
        low = glm::min(low, this->PointOf(end));
        high = glm::max(high, this->PointOf(end));
      }
    }
    const glm::vec3 size = high - low;
    const float side = std::max({ size.x, size.y, size.z, std::numeric_limits<float>::min() });
    std::vector<std::pair<std::uint64_t, ThickSegment>> order;
    order.reserve(all.size() - first);
    for (std::size_t i = first; i < all.size(); ++i)
    {
      const glm::vec3 middle = 0.5f * (this->PointOf(all[i].Start) + this->PointOf(all[i].End));
      order.emplace_back(MortonCode((middle - low) / side), all[i]);
    }
    std::stable_sort(order.begin(), order.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = first; i < all.size(); ++i)
    {
      all[i] = order[i - first].second;
    }
  }

  std::vector<ThickBlock> Divide(std::size_t first)
  {
    this->Sort(first);
    std::vector<ThickBlock> blocks;
    const std::vector<ThickSegment>& all = this->Result.Segments;
    for (; first < all.size(); first += ThickBlock::MostSegments)
    {
      const std::size_t end = std::min(first + ThickBlock::MostSegments, all.size());
      ThickBlock block{ glm::vec3(std::numeric_limits<float>::max()), {},
        static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first) };
      block.High = -block.Low;
      for (std::size_t i = first; i < end; ++i)
      {
        for (const std::uint32_t point : { all[i].Start, all[i].End })
        {
          block.Low = glm::min(block.Low, this->PointOf(point));
          block.High = glm::max(block.High, this->PointOf(point));
        }
      }
      blocks.push_back(block);
    }
    return blocks;
  }

  void AddBallSegments()
  {
    for (std::size_t i = 0; i < this->IsBall.size(); ++i)
    {
      if (this->IsBall[i])
      {
        const std::uint32_t end = std::uint32_t(i) | ThickSegment::JoinedBit;
        this->Result.Segments.push_back({ end, end });
      }
    }
  }

  // Sorts points by their first use, and drops those that nothing uses.
  void CompactPoints()
  {
    constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> place(this->Input.Points.size(), unused);
    std::vector<glm::vec3> used;
    const auto move = [&](std::uint32_t& end) {
      const std::uint32_t point = ThickSegment::Point(end);
      if (place[point] == unused)
      {
        place[point] = static_cast<std::uint32_t>(used.size());
        used.push_back(this->Input.Points[point]);
      }
      end = place[point] | (end & ThickSegment::JoinedBit);
    };
    for (ThickSegment& segment : this->Result.Segments)
    {
      move(segment.Start);
      move(segment.End);
    }
    this->Result.Points = std::move(used);
  }
};
}

ThickData BuildThickData(vtkPolyData* data, ThickLook::Shape shape, bool allPoints)
{
  const bool any = data && data->GetPoints() && data->GetNumberOfCells() > 0;
  const bool surfaceCasts = shape != ThickLook::Shape::Surface || allPoints;
  // Most meshes have none, and their points needn't be read for that.
  if (!any || (!surfaceCasts && data->GetNumberOfLines() == 0 && data->GetNumberOfVerts() == 0))
  {
    return {};
  }
  Builder builder(data);
  builder.ReadCells(shape, allPoints);
  builder.Result.Lines = builder.Divide(0);
  const std::size_t lines = builder.Result.Segments.size();
  builder.AddBallSegments();
  builder.Result.Balls = builder.Divide(lines);
  builder.CompactPoints();
  return std::move(builder.Result);
}
}
