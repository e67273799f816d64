// SPDX-License-Identifier: BSD-3-Clause
// View samples of the previous frame: shadows are right while the camera moves on, after cuts, and
// when it stands still again.
#include "rtwShadowStage.h"

#include "vtkCamera.h"

#include <cstring>

namespace
{
bool HasStage(vtkAdaptiveShadowMapPass* pass, const char* name)
{
  for (int i = 0; i < pass->GetNumberOfStages(); ++i)
  {
    if (!std::strcmp(pass->GetStageName(i), name) && pass->GetStageMilliseconds(i) > 0)
    {
      return true;
    }
  }
  return false;
}

void Check(rtwShadowStage& stage, vtkLight* light, const std::string& name)
{
  stage.Name = name;
  rtwShadowBounds bounds;
  bounds.Shadowed = 1;
  RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, bounds);
}

void TestMoves(rtwTechnique technique, rtwChain chain, bool spot)
{
  rtwShadowStage stage(technique, chain);
  stage.AddObjects();
  vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 5, 2);
  vtkAdaptiveShadowMapPass* pass = stage.Pass;
  pass->SetViewSampleSourceToPreviousFrame();
  pass->SetTimeStages(true);
  stage.Render();
  Check(stage, light, "first frame");
  int builds = pass->GetNumberOfShaderBuilds();
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  for (int i = 0; i < 6; ++i)
  {
    camera->Azimuth(0.5);
    stage.Render();
    RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 1);
  }
  RTW_CHECK_EQUAL(pass->GetNumberOfShaderBuilds(), builds);
  Check(stage, light, "moving on");
  stage.CheckPicture(0.1, __FILE__, __LINE__);
  RTW_CHECK(HasStage(pass, "resampling"));
  camera->Azimuth(30);
  stage.Render();
  builds = pass->GetNumberOfShaderBuilds(); // the picture's check has drawn others
  Check(stage, light, "cut");
  camera->Yaw(1);
  stage.Render();
  Check(stage, light, "after a cut");
  // The last frame has shown something else than this one, so that it is looked at once more.
  stage.Render();
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 1);
  stage.Render();
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersReused(), 1);
  Check(stage, light, "still");
  RTW_CHECK_EQUAL(pass->GetNumberOfShaderBuilds(), builds);
}

// What comes into view is beside the last frame's samples.
void TestOtherCuts()
{
  rtwShadowStage stage(rtwTechnique::RTW, rtwChain::Steps);
  stage.AddObjects();
  vtkLight* light = stage.AddSun(3, 5, 2);
  stage.Pass->SetViewSampleSourceToPreviousFrame();
  stage.Render();
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->Zoom(6);
  stage.Render();
  stage.Render();
  camera->Zoom(0.16);
  stage.Render();
  Check(stage, light, "zoomed out");
  camera->Roll(20);
  stage.Render();
  Check(stage, light, "rolled");
  camera->ParallelProjectionOn();
  stage.Render();
  Check(stage, light, "parallel");
  camera->SetParallelScale(1.02 * camera->GetParallelScale());
  stage.Render();
  Check(stage, light, "parallel, moving on");
  stage.Window->SetSize(200, 320);
  stage.Render();
  Check(stage, light, "another size");
  stage.Window->SetMultiSamples(4);
  stage.Render();
  stage.Render();
  Check(stage, light, "several samples a pixel");
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowPreviousFrame(int, char*[])
{
  TestMoves(rtwTechnique::RTW, rtwChain::Steps, false);
  TestMoves(rtwTechnique::RTW, rtwChain::Classic, true);
  TestMoves(rtwTechnique::Uniform, rtwChain::Steps, true);
  TestOtherCuts();
  return rtwTestResult();
}
