// SPDX-License-Identifier: BSD-3-Clause
#include "rtwEachTechnique.h"

#include "rtwDebugViews.h"

#include "vtkLightCollection.h"

void rtwCheckLights(rtwShadowStage& stage, const rtwShadowBounds& bounds)
{
  stage.AddObjects();
  vtkLight* const lights[] = { stage.AddSun(3, 5, 2), stage.AddSpot(3, 7, 2, 40),
    stage.AddSun(-5, 2, 1) };
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 3);
  for (int i = 0; i < 3; ++i)
  {
    RTW_CHECK_SHADOWS_WITHIN(stage, lights[i], i, bounds);
  }
}

void rtwCheckGlyphs(rtwShadowStage& stage)
{
  rtwFillForDebugViews(stage);
  stage.Render();
  vtkLightCollection* lights = stage.Renderer->GetLights();
  for (int i = 0; i < 2; ++i)
  {
    RTW_CHECK_SHADOWS(stage, vtkLight::SafeDownCast(lights->GetItemAsObject(i)), i);
  }
}

const char* rtwNameOf(rtwChain chain)
{
  return chain == rtwChain::Classic ? "classic" : "steps";
}
