// SPDX-License-Identifier: BSD-3-Clause
// Meshes of all kinds of cells, and meshes that change.
#include "rtwShadowStage.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"

#include <cmath>
#include <vector>

namespace
{
// Ten corners, in turn far and near. VTK draws it as a fan about the first, and so has to be its
// shadow.
vtkSmartPointer<vtkPolyData> MakeStar(double y)
{
  vtkNew<vtkPoints> points;
  std::vector<vtkIdType> corners;
  for (int i = 0; i < 10; ++i)
  {
    const double angle = vtkMath::Pi() * i / 5, radius = i % 2 ? 0.7 : 2;
    corners.push_back(
      points->InsertNextPoint(radius * std::cos(angle), y, radius * std::sin(angle)));
  }
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(10, corners.data());
  auto star = vtkSmartPointer<vtkPolyData>::New();
  star->SetPoints(points);
  star->SetPolys(polygons);
  return star;
}

void TestPolygons()
{
  rtwShadowStage stage;
  stage.Name = "star";
  stage.AddFloor();
  stage.Add(MakeStar(2));
  vtkLight* sun = stage.AddSun(1, 5, 0.5);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}

void TestStrips()
{
  rtwShadowStage stage;
  stage.Name = "strips";
  stage.AddFloor();
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0, 1.5, 0);
  ball->SetRadius(1.2);
  ball->SetThetaResolution(20);
  ball->SetPhiResolution(20);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(ball->GetOutputPort());
  strips->Update();
  RTW_CHECK(strips->GetOutput()->GetNumberOfStrips() > 0);
  stage.Add(strips);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}

vtkSmartPointer<vtkPolyData> MakeThin(bool vertices)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i <= 20; ++i)
  {
    points->InsertNextPoint(-2 + 0.2 * i, 1.5, 0.5);
  }
  for (vtkIdType i = 0; i <= 20 && vertices; ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  std::vector<vtkIdType> all;
  for (vtkIdType i = 0; i <= 20; ++i)
  {
    all.push_back(i);
  }
  auto thin = vtkSmartPointer<vtkPolyData>::New();
  thin->SetPoints(points);
  if (vertices)
  {
    thin->SetVerts(cells);
  }
  else
  {
    cells->InsertNextCell(21, all.data());
    thin->SetLines(cells);
  }
  return thin;
}

// Their shadow is as wide as they are, and lies within that of a ribbon.
void TestThin()
{
  rtwShadowStage stage;
  stage.AddFloor();
  vtkNew<vtkPlaneSource> ribbon;
  ribbon->SetOrigin(-2.2, 1.5, 0.7);
  ribbon->SetPoint1(2.2, 1.5, 0.7);
  ribbon->SetPoint2(-2.2, 1.5, 0.3);
  vtkActor* actor = stage.Add(ribbon);
  vtkLight* sun = stage.AddSun(1, 5, 2);
  stage.Render();
  const rtw::Truth wide = stage.Trace(sun);
  actor->VisibilityOff();
  const rtw::Truth empty = stage.Trace(sun);
  for (const bool vertices : { false, true })
  {
    vtkActor* thin = stage.Add(MakeThin(vertices));
    thin->GetProperty()->SetLineWidth(2);
    thin->GetProperty()->SetPointSize(2);
    stage.Render();
    const std::vector<unsigned char> mask = stage.GetMask(0);
    thin->VisibilityOff();
    size_t dark = 0, outside = 0, self = 0;
    for (size_t i = 0; i < mask.size(); ++i)
    {
      const bool onRibbon = wide.Depth[i] != empty.Depth[i];
      dark += mask[i] < 128 && !onRibbon;
      outside += mask[i] < 128 && !onRibbon && wide.Mask[i] == rtw::MASK_LIT;
      self += mask[i] < 128 && onRibbon;
    }
    std::cout << (vertices ? "vertices: " : "lines: ") << dark << " dark, " << outside
              << " outside, " << self << " on itself" << std::endl;
    RTW_CHECK(dark >= (vertices ? 15u : 60u));
    RTW_CHECK(dark < 600);
    RTW_CHECK(outside <= dark / 10);
    RTW_CHECK(self <= dark / 10); // it is lit
  }
}

// Points, then cells of the same object change between frames.
void TestAnimated()
{
  rtwShadowStage stage;
  stage.AddFloor();
  vtkNew<vtkSphereSource> source;
  source->SetCenter(-1, 1.3, 0);
  source->SetRadius(0.8);
  source->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(source->GetOutput());
  stage.Add(mesh);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  for (int frame = 0; frame < 3; ++frame)
  {
    stage.Name = "animated points " + std::to_string(frame);
    stage.Render();
    RTW_CHECK_SHADOWS(stage, sun, 0);
    vtkPoints* points = mesh->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      points->SetPoint(i, p[0] + 0.7, p[1] * 1.1, p[2]);
    }
    points->Modified();
  }
  stage.Name = "other cells";
  vtkNew<vtkCellArray> half;
  for (vtkIdType i = 0; i < mesh->GetPolys()->GetNumberOfCells(); i += 2)
  {
    vtkIdType count;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(i, count, ids);
    half->InsertNextCell(count, ids);
  }
  mesh->SetPolys(half);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  // The source of a pipeline changes.
  stage.Name = "other radius";
  vtkActor* ball = stage.Add(source);
  stage.Render();
  source->SetRadius(1.2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
  // Meshes of many sizes come and go; the same buffers hold them.
  stage.Name = "more triangles";
  source->SetThetaResolution(60);
  source->SetPhiResolution(60);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Name = "fewer triangles";
  source->SetThetaResolution(8);
  stage.AddBox(2, 1, 1, 0.8);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Name = "another removed";
  stage.Renderer->RemoveActor(ball);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}

// Actors come, go, and hide; the caster that is hidden casts nothing.
void TestComeAndGo()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  stage.Name = "added";
  vtkActor* ball = stage.AddBall(0.3, 2, 1, 0.5);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Name = "hidden";
  ball->VisibilityOff();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Name = "shown";
  ball->VisibilityOn();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Name = "clear";
  ball->GetProperty()->SetOpacity(0);
  stage.Options.Casts = [ball](vtkProp* prop) { return prop != ball; };
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Options.Casts = nullptr;
  ball->GetProperty()->SetOpacity(1);
  stage.Name = "removed";
  stage.Renderer->RemoveActor(ball);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowMeshes(int, char*[])
{
  TestPolygons();
  TestStrips();
  TestThin();
  TestAnimated();
  TestComeAndGo();
  return rtwTestResult();
}
