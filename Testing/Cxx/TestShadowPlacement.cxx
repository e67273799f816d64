// SPDX-License-Identifier: BSD-3-Clause
// Where things are: transforms, assemblies, and scenes that are tiny, huge, or far from the origin.
#include "rtwShadowStage.h"

#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <initializer_list>

namespace
{
vtkSmartPointer<vtkActor> MakePart(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void TestTransforms()
{
  rtwShadowStage stage;
  stage.Name = "scaled unevenly";
  stage.AddFloor();
  vtkActor* ball = stage.AddBall(0, 0, 0, 1);
  ball->SetPosition(-1.5, 1.2, 0);
  ball->SetScale(0.5, 1, 1.5);
  ball->RotateZ(30);
  vtkActor* box = stage.AddBox(0, 0, 0, 1);
  vtkNew<vtkTransform> shear;
  const double matrix[16] = { 1, 0.5, 0, 1.8, 0, 1, 0, 0.6, 0.2, 0, 1.5, 0, 0, 0, 0, 1 };
  shear->SetMatrix(matrix);
  box->SetUserTransform(shear);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);

  stage.Name = "moved";
  ball->AddPosition(1, 0.5, 0.5);
  shear->Translate(0, 0.5, 0);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS(stage, sun, 0);

  stage.Name = "mirrored";
  ball->SetScale(-0.5, 1, 1.5);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}

void TestAssemblies()
{
  rtwShadowStage stage;
  stage.Name = "assembly";
  stage.AddFloor();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.4);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetHeight(1.6);
  cylinder->SetRadius(0.2);
  const auto head = MakePart(sphere), body = MakePart(cylinder);
  head->SetPosition(0, 1.1, 0);
  vtkNew<vtkAssembly> inner, outer;
  inner->AddPart(head);
  inner->AddPart(body);
  inner->RotateZ(-35);
  inner->SetScale(1, 1.2, 1);
  outer->AddPart(inner);
  const auto foot = MakePart(sphere);
  foot->SetPosition(-1, 0, 0);
  outer->AddPart(foot);
  outer->SetPosition(0, 1, 0);
  outer->RotateY(40);
  stage.Renderer->AddViewProp(outer);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwShadowBounds bounds;
  bounds.Shadowed = 1;
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "assembly, turned";
  inner->RotateZ(60);
  outer->AddPosition(0.5, 0.3, 0);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "assembly, part hidden";
  head->VisibilityOff();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
}

// The usual scene, of another size and elsewhere, both in its points and by its actors' transforms.
void TestScale(const char* name, double scale, double shift, bool byTransform, bool spot,
  const rtwShadowBounds& bounds = rtwShadowBounds())
{
  rtwShadowStage stage;
  stage.Name = std::string(name) + (byTransform ? " by transform" : "") + (spot ? " spot" : "");
  const double s = byTransform ? 1 : scale, o = byTransform ? 0 : shift;
  vtkNew<vtkPlaneSource> floor;
  floor->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  floor->SetOrigin(o - 6 * s, o, o + 6 * s);
  floor->SetPoint1(o + 6 * s, o, o + 6 * s);
  floor->SetPoint2(o - 6 * s, o, o - 6 * s);
  vtkNew<vtkSphereSource> ball;
  ball->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  ball->SetCenter(o - 1.2 * s, o + 1.3 * s, o);
  ball->SetRadius(s);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  vtkNew<vtkCubeSource> box;
  box->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  box->SetCenter(o + 1.8 * s, o + 0.6 * s, o - 0.5 * s);
  box->SetXLength(1.2 * s);
  box->SetYLength(1.2 * s);
  box->SetZLength(1.2 * s);
  for (vtkAlgorithm* source :
    std::initializer_list<vtkAlgorithm*>{ floor.Get(), ball.Get(), box.Get() })
  {
    vtkActor* actor = stage.Add(source);
    if (byTransform)
    {
      actor->SetScale(scale);
      actor->SetPosition(shift, shift, shift);
    }
  }
  const auto at = [&](double x) { return shift + scale * x; };
  vtkLight* light =
    spot ? stage.AddSpot(at(3), at(7), at(2), 40) : stage.AddSun(at(3), at(5), at(2));
  light->SetFocalPoint(shift, shift, shift);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(at(1), at(6), at(9));
  camera->SetFocalPoint(at(0), at(0.5), at(0));
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, bounds);
}

void TestScales()
{
  for (const bool spot : { false, true })
  {
    TestScale("tiny", 1e-4, 0, false, spot);
    TestScale("huge", 1e5, 0, false, spot);
    TestScale("large coordinates", 1, 1e6, true, spot);
    TestScale("large coordinates", 1, 1e6, false, spot);
  }
}
}

int TestShadowPlacement(int, char*[])
{
  TestTransforms();
  TestAssemblies();
  TestScales();
  return rtwTestResult();
}
