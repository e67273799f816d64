// SPDX-License-Identifier: BSD-3-Clause
// Shadows are right again after their resources, their context, or their window went.
#include "rtwShadowStage.h"

namespace
{
// A frame without the pass, one after all its resources went, and one in a new context.
void TestReleased(rtwChain chain)
{
  rtwShadowStage stage(rtwTechnique::RTW, chain);
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  const auto check = [&](const char* name) {
    stage.Name = std::string(name) + (chain == rtwChain::Classic ? " classic" : " steps");
    stage.Render();
    RTW_CHECK_SHADOWS(stage, sun, 0);
  };
  check("before");
  const vtkTypeInt64 memory = stage.Pass->GetShadowMemory();
  for (int i = 0; i < 3; ++i)
  {
    stage.UsePass(false);
    stage.Render();
    stage.UsePass(true);
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetShadowMemory(), memory);
  }
  check("used again");
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  check("released");
  stage.Renderer->ReleaseGraphicsResources(stage.Window);
  check("renderer released");
  stage.Window->Finalize();
  check("new context");
  RTW_CHECK_PICTURE(stage);
  // Another window takes over the renderer.
  stage.Window->RemoveRenderer(stage.Renderer);
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetSize(220, 240);
  other->AddRenderer(stage.Renderer);
  stage.Renderer->ResetCameraClippingRange();
  other->Render();
  stage.Name = "other window";
  RTW_CHECK_SHADOWS(stage, sun, 0);
  other->RemoveRenderer(stage.Renderer);
}
}

int TestShadowReleased(int, char*[])
{
  TestReleased(rtwChain::Steps);
  TestReleased(rtwChain::Classic);
  return rtwTestResult();
}
