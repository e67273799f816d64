// SPDX-License-Identifier: BSD-3-Clause
// All kinds and numbers of lights: which cast shadows, which don't need to, and which can't.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

namespace
{
// Several lights, one of them off and listed first, and a headlight between them.
void TestSeveral(int argc, char* argv[])
{
  rtwShadowStage stage;
  stage.Name = "several";
  stage.AddObjects();
  stage.AddSun(-5, 2, 0)->SwitchOff();
  vtkLight* left = stage.AddSun(-3, 5, 2);
  left->SetColor(0.4, 0.1, 0.1);
  vtkLight* head = stage.AddSun(0, 0, 1);
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.1);
  vtkLight* right = stage.AddSun(3, 5, 2);
  right->SetColor(0.1, 0.4, 0.1);
  vtkLight* spot = stage.AddSpot(0, 6, 4, 30);
  spot->SetColor(0.1, 0.1, 0.4);
  stage.Render();
  rtwCompareWithBaseline(stage.Window, argc, argv);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 3);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLightsSkipped(), 1);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 3);
  RTW_CHECK_SHADOWS(stage, left, 0);
  RTW_CHECK_SHADOWS(stage, right, 1);
  RTW_CHECK_SHADOWS(stage, spot, 2);
  RTW_CHECK(stage.Pass->GetShadowMask(3) == nullptr);
  RTW_CHECK_PICTURE(stage);

  // One is switched off, another on: the numbers of the rest change.
  stage.Name = "several, another off";
  left->SwitchOff();
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 2);
  RTW_CHECK_SHADOWS(stage, right, 0);
  RTW_CHECK_SHADOWS(stage, spot, 1);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "several, on again";
  left->SwitchOn();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, left, 0);
  RTW_CHECK_SHADOWS(stage, spot, 2);
  RTW_CHECK_PICTURE(stage);
}

// A shadow that weighs less, and lights whose shadows don't count.
void TestSkipped()
{
  rtwShadowStage stage;
  stage.AddObjects();
  stage.Name = "half attenuation";
  vtkLight* light = stage.AddSun(3, 5, 2);
  light->SetShadowAttenuation(0.5f);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, light, 0);
  RTW_CHECK_PICTURE(stage);

  stage.Name = "whole attenuation again";
  light->SetShadowAttenuation(1);
  stage.Render();
  RTW_CHECK_PICTURE(stage);

  stage.Name = "skipped";
  vtkLight* weightless = stage.AddSun(-3, 5, 2);
  weightless->SetColor(0.3, 0, 0);
  weightless->SetShadowAttenuation(0);
  vtkLight* black = stage.AddSun(-1, 5, 2);
  black->SetColor(0, 0, 0);
  stage.AddSun(-2, 5, 2)->SetIntensity(0);
  light->SetIntensity(0.6);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLightsSkipped(), 3);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 1);
  RTW_CHECK_SHADOWS(stage, light, 0);
  RTW_CHECK_PICTURE(stage);

  stage.Name = "none left";
  light->SwitchOff();
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 0);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 0);
  RTW_CHECK(stage.Pass->GetShadowMask(0) == nullptr);
  RTW_CHECK_PICTURE(stage);
}

// Lights that move with the camera, and those that a matrix moves.
void TestPlaced()
{
  rtwShadowStage stage;
  stage.AddObjects();
  stage.Name = "camera light";
  vtkLight* light = stage.AddSun(0, 0, 0);
  light->SetLightTypeToCameraLight();
  light->SetPosition(1, 0.8, 1);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, light, 0);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "camera light, moved";
  stage.Renderer->GetActiveCamera()->Azimuth(40);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, light, 0);
  RTW_CHECK_PICTURE(stage);

  light->SwitchOff();
  vtkNew<vtkTransform> turn;
  turn->RotateY(70);
  turn->Scale(1.5, 1, 1);
  for (const bool spot : { false, true })
  {
    stage.Name = spot ? "spot with matrix" : "sun with matrix";
    vtkLight* moved = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 5, 2);
    moved->SetTransformMatrix(turn->GetMatrix());
    stage.Render();
    RTW_CHECK_SHADOWS(stage, moved, 0);
    RTW_CHECK_PICTURE(stage);
    // A light that is moved on by its matrix alone.
    turn->RotateY(-40);
    stage.Name += ", moved on";
    stage.Render();
    RTW_CHECK_SHADOWS(stage, moved, 0);
    moved->SwitchOff();
  }
}

// A spot whose rim crosses the view, and one with objects in its back.
void TestSpots()
{
  rtwShadowStage stage;
  stage.AddObjects();
  for (const double cone : { 5.0, 60.0, 85.0 })
  {
    stage.Name = "cone of " + std::to_string(int(cone));
    vtkLight* light = stage.AddSpot(-2, 5, 3, cone);
    light->SetFocalPoint(-1.2, 1.3, 0);
    stage.Render();
    rtwShadowBounds bounds;
    bounds.Shadowed = 0;
    RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, bounds);
    RTW_CHECK_PICTURE(stage);
    light->SwitchOff();
  }
  stage.Name = "outside of a cone";
  vtkLight* narrow = stage.AddSpot(0, 8, 0, 10);
  stage.Render();
  const vtkSmartPointer<vtkImageData> mask = stage.Pass->GetShadowMask(0);
  for (const int x : { 5, 290 })
  {
    RTW_CHECK_EQUAL(int(*static_cast<unsigned char*>(mask->GetScalarPointer(x, 40, 0))), 128);
  }
  narrow->SwitchOff();

  stage.Name = "spot between the objects";
  vtkLight* low = stage.AddSpot(0.6, 0.9, 0.8, 80);
  low->SetFocalPoint(-1.2, 0.4, 0);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, low, 0);
  RTW_CHECK_PICTURE(stage);
}

void TestPointLight()
{
  rtwShadowStage stage;
  stage.Name = "point light";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  sun->SetIntensity(0.6);
  vtkLight* point = stage.AddSpot(-3, 3, 3, 90);
  point->SetIntensity(0.3);
  rtwMessageCatcher messages(stage.Pass);
  stage.Render();
  stage.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK(messages.GetText().find("90") != std::string::npos);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 1);
  RTW_CHECK_SHADOWS(stage, sun, 0);
  point->SetShadowAttenuation(0); // as the exact picture has to have it
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowLights(int argc, char* argv[])
{
  TestSeveral(argc, argv);
  TestSkipped();
  TestPlaced();
  TestSpots();
  TestPointLight();
  return rtwTestResult();
}
