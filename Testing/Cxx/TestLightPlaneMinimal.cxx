// SPDX-License-Identifier: BSD-3-Clause
// The light plane turned to the minimal shadow frustum: shadows are as right as ever, with view
// samples or without, and a map has no less texels for what is seen. With the argument
// "all" six scenes.
#include "rtwSceneStage.h"
#include "rtwShadowStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkShadowRenderStepsPass.h"
#include "vtkUniformShadowMapPass.h"

#include <iostream>
#include <string>

namespace
{
// A long row of boxes that the view looks along, aslant to the axes.
void Fill(rtwShadowStage& stage)
{
  stage.AddFloor(60);
  for (int i = -6; i <= 6; ++i)
  {
    stage.AddBox(2.0 * i, 0.5, 2.2 * i + 1, 1);
    stage.AddBox(2.0 * i + 3, 0.5, 2.2 * i - 1, 1);
  }
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(-11, 1.6, -12);
  camera->SetFocalPoint(0, 0.5, 0);
  camera->SetViewAngle(25);
  stage.Renderer->ResetCameraClippingRange();
}

double Texels(rtwShadowStage& stage, int light)
{
  return stage.Pass->GetMaximumEffectiveResolution(light, 0) *
    stage.Pass->GetMaximumEffectiveResolution(light, 1);
}

void TestFocus(rtwTechnique technique, rtwChain chain, bool samples)
{
  rtwShadowStage stage(technique, chain);
  stage.Name = samples ? "with view samples" : "without view samples";
  Fill(stage);
  vtkLight* sun = stage.AddSun(3, 5, 1);
  vtkLight* spot = stage.AddSpot(-2, 16, 3, 60);
  stage.Pass->SetFocusOnView(samples);
  stage.Pass->SetResolution(2048);
  stage.Render();
  const double plain[] = { Texels(stage, 0), Texels(stage, 1) };
  stage.Pass->SetLightPlaneTurnToMinimalFrustum();
  stage.Render();
  for (int light = 0; light < 2; ++light)
  {
    const double share = Texels(stage, light) / plain[light];
    std::cout << stage.Name << ", light " << light << ": " << share
              << " times as many texels for what is seen" << std::endl;
    // A warp goes by what is seen, with and without a turn.
    RTW_CHECK(technique != rtwTechnique::Uniform || share > (samples ? 1 : 2));
  }
  rtwShadowBounds bounds;
  bounds.Shadowed = 0.2;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_SHADOWS_WITHIN(stage, spot, 1, bounds);
}

// What is seen is all of the scene, or as good as.
void TestWhole()
{
  rtwShadowStage stage(rtwTechnique::Uniform);
  stage.Name = "whole";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Pass->SetLightPlaneTurnToMinimalFrustum();
  stage.Pass->FocusOnViewOff();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0, 30, 0.01); // all at once
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, -1);
  stage.Renderer->ResetCameraClippingRange();
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

// Of the light plane, how much a map holds, beside one that isn't turned.
void TestScene(const char* name)
{
  rtwSceneStage stage(name);
  vtkNew<vtkUniformShadowMapPass> pass;
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(pass);
  stage.Renderer->SetPass(steps);
  double areas[2][2];
  for (const bool samples : { false, true })
  {
    for (const bool turned : { false, true })
    {
      pass->SetFocusOnView(samples);
      pass->SetLightPlaneTurn(turned ? vtkAdaptiveShadowMapPass::TURN_MINIMAL_FRUSTUM
                                     : vtkAdaptiveShadowMapPass::TURN_OFF);
      stage.Window->Render();
      areas[samples][turned] =
        1 / (pass->GetMaximumEffectiveResolution(0, 0) * pass->GetMaximumEffectiveResolution(0, 1));
    }
  }
  steps->ReleaseGraphicsResources(stage.Window);
  stage.Renderer->SetPass(nullptr);
  std::cout << name << ": the minimal frustum has " << areas[0][1] / areas[0][0]
            << " of the whole scene's area; around what is seen, so turned, "
            << areas[1][1] / areas[1][0] << " of the area without a turn" << std::endl;
  RTW_CHECK(areas[0][1] <= 1.001 * areas[0][0]);
  RTW_CHECK(areas[1][1] <= 1.001 * areas[1][0]);
  RTW_CHECK(areas[1][1] <= 1.12 * areas[0][1]); // what is seen lies in it; it stays for a tenth
}
}

int TestLightPlaneMinimal(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  int scenes = 0;
  for (const char* name : { "town", "duel", "robot", "sandbox", "furball", "playground" })
  {
    if (all || scenes++ < 2)
    {
      TestScene(name);
    }
  }
  TestFocus(rtwTechnique::Uniform, rtwChain::Steps, false);
  TestFocus(rtwTechnique::Uniform, rtwChain::Classic, true);
  TestFocus(rtwTechnique::RTW, rtwChain::Steps, true);
  TestFocus(rtwTechnique::NoTW, rtwChain::Steps, true);
  TestWhole();
  return rtwTestResult();
}
