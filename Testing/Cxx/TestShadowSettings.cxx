// SPDX-License-Identifier: BSD-3-Clause
#include "rtwShadowStage.h"

#include "vtkIdentityShadowMapWarp.h"
#include "vtkRectilinearShadowMapWarp.h"

// Every combination of settings decides alike, but for errors of their own.
int TestShadowSettings(int, char*[])
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.2;
  vtkNew<vtkIdentityShadowMapWarp> identity;
  vtkNew<vtkRectilinearShadowMapWarp> published;
  published->SetImportance(
    vtkRectilinearShadowMapWarp::DISTANCE_TO_EYE | vtkRectilinearShadowMapWarp::SURFACE_NORMAL);
  for (const int filter : { vtkAdaptiveShadowMapPass::NEAREST, vtkAdaptiveShadowMapPass::BILINEAR })
  {
    for (const int test : { vtkAdaptiveShadowMapPass::DUAL,
           vtkAdaptiveShadowMapPass::RECEIVER_PLANE, vtkAdaptiveShadowMapPass::CONSTANT_BIAS })
    {
      stage.Name = "filter " + std::to_string(filter) + ", test " + std::to_string(test);
      stage.Pass->SetFilter(filter);
      stage.Pass->SetDepthTest(test);
      stage.Pass->SetConstantBias(0.01);
      stage.Render();
      RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
    }
  }
  stage.Pass->SetDepthTestToDual();
  stage.Name = "published importance";
  stage.Pass->SetWarp(published);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "warp changed";
  published->SetImportanceResolution(64);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "identity";
  stage.Pass->SetWarp(identity);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "linear";
  stage.Pass->SetRasterizationToLinear();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "culling off";
  stage.Pass->CullCastersOff();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfCastersCulled(0), 0);
  return rtwTestResult();
}
