// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwThickData.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace
{
using Shape = rtw::ThickLook::Shape;

// A row of points one apart.
vtkSmartPointer<vtkPolyData> MakeRow(int count)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(i, 0, 0);
  }
  auto row = vtkSmartPointer<vtkPolyData>::New();
  row->SetPoints(points);
  row->SetVerts(vtkSmartPointer<vtkCellArray>::New());
  row->SetLines(vtkSmartPointer<vtkCellArray>::New());
  row->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  return row;
}

void AddCell(vtkCellArray* cells, std::vector<vtkIdType> ids)
{
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
}

bool IsJoined(std::uint32_t end)
{
  return (end & rtw::ThickSegment::JoinedBit) != 0;
}

int CountJoined(const rtw::ThickData& data)
{
  int joined = 0;
  for (const rtw::ThickSegment& segment : data.Segments)
  {
    joined += IsJoined(segment.Start) + IsJoined(segment.End);
  }
  return joined;
}

std::uint32_t Count(const std::vector<rtw::ThickBlock>& blocks)
{
  std::uint32_t count = 0;
  for (const rtw::ThickBlock& block : blocks)
  {
    EXPECT_LE(block.Count, rtw::ThickBlock::MostSegments);
    count += block.Count;
  }
  return count;
}
}

TEST(ThickData, NothingOfNothing)
{
  EXPECT_TRUE(rtw::BuildThickData(nullptr, Shape::Surface, false).IsEmpty());
  EXPECT_TRUE(rtw::BuildThickData(MakeRow(3), Shape::Edges, true).IsEmpty());
}

// A polyline of 200 lines is joined everywhere but at its two ends, a loop at all.
TEST(ThickData, PolylinesAreJoined)
{
  const auto row = MakeRow(201);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i <= 200; ++i)
  {
    ids.push_back(i);
  }
  AddCell(row->GetLines(), ids);
  const rtw::ThickData open = rtw::BuildThickData(row, Shape::Surface, false);
  EXPECT_EQ(Count(open.Lines), 200u);
  EXPECT_EQ(Count(open.Balls), 0u);
  EXPECT_EQ(CountJoined(open), 2 * 200 - 2);

  const auto triangle = MakeRow(3);
  AddCell(triangle->GetLines(), { 0, 1, 2, 0 });
  EXPECT_EQ(CountJoined(rtw::BuildThickData(triangle, Shape::Surface, false)), 6);
}

// Two triangles side by side have five edges and four points; as a surface neither is drawn.
TEST(ThickData, EdgesAndPointsOfSurfaces)
{
  const auto mesh = MakeRow(4);
  AddCell(mesh->GetPolys(), { 0, 1, 2 });
  AddCell(mesh->GetPolys(), { 2, 1, 3 });
  EXPECT_TRUE(rtw::BuildThickData(mesh, Shape::Surface, false).IsEmpty());
  const rtw::ThickData edges = rtw::BuildThickData(mesh, Shape::Edges, false);
  EXPECT_EQ(Count(edges.Lines), 5u);
  EXPECT_EQ(Count(edges.Balls), 0u);
  const rtw::ThickData points = rtw::BuildThickData(mesh, Shape::Points, false);
  EXPECT_EQ(Count(points.Lines), 0u);
  EXPECT_EQ(Count(points.Balls), 4u);
  EXPECT_EQ(Count(rtw::BuildThickData(mesh, Shape::Surface, true).Balls), 4u);
}

TEST(ThickData, LeavesOutWhatIsNowhere)
{
  const auto row = MakeRow(4);
  row->GetPoints()->SetPoint(2, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  AddCell(row->GetLines(), { 0, 1, 2, 3 });
  AddCell(row->GetVerts(), { 2 });
  AddCell(row->GetVerts(), { 3 });
  const rtw::ThickData data = rtw::BuildThickData(row, Shape::Surface, false);
  EXPECT_EQ(Count(data.Lines), 1u);
  EXPECT_EQ(Count(data.Balls), 1u);
  EXPECT_EQ(data.Points.size(), 3u);
}
