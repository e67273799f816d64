// SPDX-License-Identifier: BSD-3-Clause
// What VTK has mappers of its own for: composite data, data sets, glyphs, imposters, levels of
// detail, clipped meshes.
#include "rtwShadowStage.h"

#include "rtwCompositeMapper.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkConeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLODActor.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace
{
const char* NameOf(rtwTechnique technique)
{
  return technique == rtwTechnique::RTW ? ", rtw" : ", uniform";
}

vtkActor* AddMapper(rtwShadowStage& stage, vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkPolyData> MakeBall(double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(x, y, z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(20);
  ball->SetPhiResolution(20);
  ball->Update();
  return ball->GetOutput();
}

void TestComposite()
{
  rtwShadowStage stage;
  stage.AddFloor();
  vtkNew<vtkMultiBlockDataSet> outer, inner;
  inner->SetBlock(0, MakeBall(-2, 1.2, 0, 0.8));
  inner->SetBlock(1, MakeBall(0, 1.2, 0, 0.8));
  outer->SetBlock(0, inner);
  outer->SetBlock(1, MakeBall(2, 1.2, 0, 0.8));
  outer->SetBlock(2, nullptr);
  vtkNew<rtw::CompositeMapper> mapper;
  mapper->SetInputDataObject(outer);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  AddMapper(stage, mapper);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Name = "composite";
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "composite, one hidden";
  attributes->SetBlockVisibility(inner->GetBlock(1), false);
  mapper->Modified();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "composite, parent hidden";
  attributes->RemoveBlockVisibility(inner->GetBlock(1));
  attributes->SetBlockVisibility(inner, false);
  mapper->Modified();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Name = "composite, all shown";
  attributes->RemoveBlockVisibilities();
  mapper->Modified();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestDataSets()
{
  rtwShadowStage stage;
  stage.Name = "grids";
  stage.AddFloor();
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 5);
  image->SetSpacing(0.4, 0.5, 0.3);
  image->SetOrigin(0.8, 0.2, -0.5);
  vtkNew<vtkDataSetMapper> box;
  box->SetInputData(image);
  AddMapper(stage, box);
  vtkNew<vtkAppendFilter> grid; // its output is unstructured
  grid->AddInputData(MakeBall(-1.5, 1.2, 0, 0.9));
  vtkNew<vtkDataSetMapper> ball;
  ball->SetInputConnection(grid->GetOutputPort());
  AddMapper(stage, ball);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  // The first frame, when such a mapper has not made its surface yet.
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "grids, moved";
  image->SetOrigin(1.2, 0.6, 0);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}

void TestGlyphs(rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  stage.AddFloor();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> directions;
  directions->SetName("directions");
  directions->SetNumberOfComponents(3);
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(-2.5 + 1.6 * (i % 4), 0.7 + 0.3 * (i % 3), -1.2 + 1.2 * (i / 4));
    directions->InsertNextTuple3(1, 1 - 0.4 * (i % 5), 0.3 * (i % 2));
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->AddArray(directions);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(12);
  cone->SetHeight(1);
  cone->SetRadius(0.35);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetOrientationArray("directions");
  mapper->SetOrientationModeToDirection();
  AddMapper(stage, mapper);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.2; // VTK's mapper draws them, into a map without a warp
  for (const bool spot : { false, true })
  {
    vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : sun;
    stage.Name = std::string(spot ? "glyphs, spot" : "glyphs") + NameOf(technique);
    stage.Render();
    RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, bounds);
    RTW_CHECK_PICTURE(stage);
    light->SwitchOff();
  }
  sun->SwitchOn();
  stage.Name = std::string("glyphs, moved") + NameOf(technique);
  points->SetPoint(5, 1, 2, 0);
  points->Modified();
  places->Modified();
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
}

vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

void AddSpheres(rtwShadowStage& stage)
{
  vtkNew<vtkPoints> points;
  const auto radii = MakeArray("radius", 1);
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(-2.5 + i, 0.8 + 0.2 * (i % 3), 0.4 * (i % 2));
    radii->InsertNextValue(0.3f + 0.05f * float(i));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(radii);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("radius");
  AddMapper(stage, mapper);
}

void AddSticks(rtwShadowStage& stage)
{
  vtkNew<vtkPoints> points;
  const auto directions = MakeArray("direction", 3), sizes = MakeArray("size", 3);
  vtkNew<vtkUnsignedCharArray> colours; // without, vtkOpenGLStickMapper of VTK 9.1 crashes
  colours->SetNumberOfComponents(3);
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(-2.5 + i, 1.1 + 0.2 * (i % 3), 1.5 + 0.4 * (i % 2));
    double direction[3] = { 1, 1, 0.3 * i - 1 };
    vtkMath::Normalize(direction); // it takes no others
    directions->InsertNextTuple(direction);
    sizes->InsertNextTuple3(1, 0.15, 0);
    colours->InsertNextTuple3(255, 255, 255);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(directions);
  data->GetPointData()->AddArray(sizes);
  data->GetPointData()->SetScalars(colours);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetOrientationArray("direction");
  mapper->SetScaleArray("size");
  AddMapper(stage, mapper);
}

void TestImposters(rtwTechnique technique, bool sticks)
{
  rtwShadowStage stage(technique);
  stage.AddFloor();
  sticks ? AddSticks(stage) : AddSpheres(stage);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.2;
  for (const bool spot : { false, true })
  {
    stage.Name =
      std::string(sticks ? "sticks" : "spheres") + (spot ? ", spot" : "") + NameOf(technique);
    vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 5, 2);
    stage.Render();
    RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, bounds);
    RTW_CHECK_PICTURE(stage);
    light->SwitchOff();
  }
}

void TestClipped(rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  stage.Name = std::string("clipped") + NameOf(technique);
  stage.AddFloor();
  vtkActor* ball = stage.AddBall(0, 1.5, 0, 1.3, 60);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 1.6, 0);
  plane->SetNormal(-0.3, -1, 0.2);
  ball->GetMapper()->AddClippingPlane(plane);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  rtwShadowBounds bounds;
  bounds.Wrong = 0.2;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
  stage.Name += ", plane moved";
  plane->SetOrigin(0, 0.8, 0);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
}

void TestLevelOfDetail()
{
  rtwShadowStage stage;
  stage.Name = "level of detail";
  stage.AddFloor();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeBall(0, 1.4, 0, 1));
  vtkNew<vtkLODActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Window->SetDesiredUpdateRate(0.0001); // so slow that the finest level is chosen
  stage.Render();
  rtwShadowBounds bounds;
  bounds.Wrong = 0.2;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
}
}

int TestShadowMappers(int, char*[])
{
  TestComposite();
  TestDataSets();
  TestLevelOfDetail();
  for (const rtwTechnique technique : { rtwTechnique::Uniform, rtwTechnique::RTW })
  {
    TestGlyphs(technique);
    TestImposters(technique, false);
    TestImposters(technique, true);
    TestClipped(technique);
  }
  return rtwTestResult();
}
