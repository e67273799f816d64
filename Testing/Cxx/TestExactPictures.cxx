// SPDX-License-Identifier: BSD-3-Clause
// What exact shadows look like, beside their debug view of how many view samples texels hold: the
// first frame, and one in which nothing is drawn anew.
#include "rtwDebugViews.h"

#include "vtkExactShadowMapPass.h"

int TestExactPictures(int argc, char* argv[])
{
  rtwShadowStage stages[2]{ rtwShadowStage(rtwTechnique::Exact),
    rtwShadowStage(rtwTechnique::Exact) };
  vtkRenderWindow* window = stages[0].Window;
  for (int i = 0; i < 2; ++i)
  {
    rtwShadowStage& stage = stages[i];
    rtwFillForDebugViews(stage);
    stage.Pass->SetResolution(64); // so that texels are seen
    stage.Renderer->SetBackground(0.1, 0.2, 0.3);
    stage.Renderer->SetViewport(0.5 * i, 0, 0.5 + 0.5 * i, 1);
    if (i > 0)
    {
      stage.Window->RemoveRenderer(stage.Renderer);
      window->AddRenderer(stage.Renderer);
    }
    stage.Renderer->ResetCameraClippingRange();
  }
  stages[1].Pass->SetDebugViewToListLengths();
  window->SetSize(600, 200);
  for (int frame = 0; frame < 2; ++frame)
  {
    window->Render();
    rtwCompareWithBaseline(window, argc, argv);
  }
  window->RemoveRenderer(stages[1].Renderer);
  return rtwTestResult();
}
