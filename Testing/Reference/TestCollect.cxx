// SPDX-License-Identifier: BSD-3-Clause
// Whatever way things come into a renderer, they are the same triangles.
#include "rtwCompositeMapper.h"
#include "rtwStage.h"

#include <vtkAssembly.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCylinderSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

namespace
{
vtkSmartPointer<vtkPolyData> Column()
{
  vtkNew<vtkCylinderSource> cylinder; // along y, so that its orientation shows
  cylinder->SetHeight(1.5);
  cylinder->SetRadius(0.25);
  cylinder->SetCenter(0, 0.75, 0);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cylinder->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkDoubleArray> MakeArray(
  const char* name, int components, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

void AddColumn(Stage& stage, vtkTransform* transform)
{
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(Column());
  filter->SetTransform(transform);
  stage.Renderer->AddActor(MakeActor(filter.Get()));
}

vtkSmartPointer<vtkPolyData> Ball(double x)
{
  const auto ball = MakeBall(x);
  ball->GetMapper()->Update();
  return vtkPolyData::SafeDownCast(ball->GetMapper()->GetInputDataObject(0, 0));
}
}

TEST(Reference, HiddenBlocksAreLeftOut)
{
  vtkNew<vtkMultiBlockDataSet> outer, inner;
  inner->SetBlock(0, Ball(1));
  inner->SetBlock(1, Ball(-1.5));
  outer->SetBlock(0, inner);
  outer->SetBlock(1, Ball(4));
  vtkNew<rtw::CompositeMapper> mapper;
  mapper->SetInputDataObject(outer);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  Stage stage;
  stage.Renderer->AddActor(actor);
  const size_t triangles = rtw::ShadowReference(stage.Renderer).NumberOfPrimitives();
  EXPECT_EQ(triangles, 2u + 3 * 96);

  // The left ball alone, because its own visibility comes before its parent's.
  attributes->SetBlockVisibility(outer, false);
  attributes->SetBlockVisibility(inner->GetBlock(1), true);
  Stage plain;
  plain.Renderer->AddActor(MakeBall(-1.5));
  EXPECT_EQ(Differences(stage.Trace(), plain.Trace()), 0u);
}

TEST(Reference, AssembliesAndStripsAreTheSameAsActors)
{
  Stage plain;
  plain.Renderer->AddActor(MakeBall(1));
  plain.Renderer->AddActor(MakeBall(-1.5));

  Stage stage;
  vtkNew<vtkAssembly> inner, outer;
  const auto ball = MakeBall(0);
  ball->SetPosition(1, 0, 0);
  inner->AddPart(ball);
  inner->SetPosition(0, 0, 2);
  outer->AddPart(inner);
  outer->SetPosition(0, 0, -2);
  stage.Renderer->AddActor(outer);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-1.5, 1.5, 0);
  sphere->SetRadius(0.8);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  stage.Renderer->AddActor(MakeActor(strips.Get()));

  EXPECT_EQ(rtw::ShadowReference(stage.Renderer).NumberOfPrimitives(),
    rtw::ShadowReference(plain.Renderer).NumberOfPrimitives());
  EXPECT_LE(Differences(stage.Trace(), plain.Trace()), 2u);
  rtw::ReferenceOptions options;
  options.Casts = [&](vtkProp* prop) { return prop != outer; };
  EXPECT_LT(stage.Shadowed(options), stage.Shadowed());
}

TEST(Reference, GlyphsAreTheSameAsActors)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-2, 0.5, 0);
  points->InsertNextPoint(1, 0.5, 1);
  points->InsertNextPoint(0, 0.5, -1);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->AddArray(MakeArray("turn", 3, { 10, 20, 30, 0, 90, 45, -60, 0, 0 }));
  places->GetPointData()->AddArray(MakeArray("size", 3, { 1, 2, 1, 1, 1, 1, 3, 0.5, 3 }));
  places->GetPointData()->AddArray(MakeArray("shown", 1, { 1, 1, 0 }));
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceData(Column());
  glyphs->SetOrientationArray("turn");
  glyphs->SetOrientationModeToRotation();
  glyphs->SetScaleArray("size");
  glyphs->SetScaleModeToScaleByVectorComponents();
  glyphs->SetScaleFactor(1.2);
  glyphs->MaskingOn();
  glyphs->SetMaskArray("shown");
  vtkNew<vtkActor> actor;
  actor->SetMapper(glyphs);
  Stage stage;
  stage.Renderer->AddActor(actor);

  Stage plain;
  vtkNew<vtkTransform> first, second;
  first->Translate(-2, 0.5, 0);
  first->RotateZ(30);
  first->RotateX(10);
  first->RotateY(20);
  first->Scale(1.2, 2.4, 1.2);
  AddColumn(plain, first);
  second->Translate(1, 0.5, 1);
  second->RotateZ(45);
  second->RotateY(90);
  second->Scale(1.2, 1.2, 1.2);
  AddColumn(plain, second);
  EXPECT_GT(plain.Shadowed(), 50u);
  EXPECT_LE(Differences(stage.Trace(), plain.Trace()), 2u);
}

TEST(Reference, GlyphsPointAlongVectors)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1, 1, 0);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  places->GetPointData()->SetVectors(MakeArray("v", 3, { 0, 0, 2 }));
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceData(Column());
  glyphs->SetOrientationArray(vtkDataSetAttributes::VECTORS);
  glyphs->SetScaleArray(vtkDataSetAttributes::VECTORS);
  glyphs->SetScaleModeToScaleByMagnitude();
  vtkNew<vtkActor> actor;
  actor->SetMapper(glyphs);
  Stage stage;
  stage.Renderer->AddActor(actor);

  Stage plain; // x goes to z, so that y, along the cone, is turned to -y
  vtkNew<vtkTransform> transform;
  transform->Translate(-1, 1, 0);
  transform->RotateWXYZ(180, 1, 0, 1);
  transform->Scale(2, 2, 2);
  AddColumn(plain, transform);
  EXPECT_GT(plain.Shadowed(), 15u);
  EXPECT_LE(Differences(stage.Trace(), plain.Trace()), 2u);
}

TEST(Reference, SticksAreCylinders)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 1.2, 0);
  vtkNew<vtkFloatArray> sizes, directions;
  sizes->SetName("size");
  sizes->SetNumberOfComponents(3);
  sizes->InsertNextTuple3(2, 0.3, 0);
  directions->SetName("direction");
  directions->SetNumberOfComponents(3);
  directions->InsertNextTuple3(0, 1, 0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->GetPointData()->AddArray(sizes);
  data->GetPointData()->AddArray(directions);
  vtkNew<vtkOpenGLStickMapper> sticks;
  sticks->SetInputData(data);
  sticks->SetScaleArray("size");
  sticks->SetOrientationArray("direction");
  vtkNew<vtkActor> actor;
  actor->SetMapper(sticks);
  Stage stage;
  stage.Renderer->AddActor(actor);

  Stage plain;
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetCenter(0.5, 1.2, 0);
  cylinder->SetHeight(2);
  cylinder->SetRadius(0.3);
  cylinder->SetResolution(400);
  plain.Renderer->AddActor(MakeActor(cylinder.Get()));
  EXPECT_GT(plain.Shadowed(), 50u);
  EXPECT_LE(Differences(stage.Trace(), plain.Trace()), 4u);
}
