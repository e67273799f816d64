// SPDX-License-Identifier: BSD-3-Clause
#include "rtwEachTechnique.h"

#include "rtwDebugViews.h"

#include "vtkLightCollection.h"
#include "vtkPlaneSource.h"

namespace
{
struct Stage : rtwShadowStage
{
  Stage(const rtwTechniqueCase& technique, const std::string& what, rtwChain chain)
    : rtwShadowStage(technique.MakePass(), chain)
  {
    this->Name = technique.Name + ", " + what + ", " + rtwNameOf(chain);
    this->Options.Sharp = technique.Sharp;
  }
};

void CheckFirstFrame(const rtwTechniqueCase& technique, rtwChain chain, bool spot)
{
  Stage stage(technique, spot ? "spot" : "sun", chain);
  stage.AddObjects();
  vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 1);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), technique.Layers);
  RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, technique.Bounds);
  RTW_CHECK_PICTURE(stage);
}

// A plank that reaches from behind a lamp into its light casts with the part that is before it.
void CheckPlank(const rtwTechniqueCase& technique, rtwChain chain)
{
  Stage stage(technique, "beside a lamp", chain);
  stage.Options.Sharp = true;
  stage.AddFloor();
  vtkNew<vtkPlaneSource> plank;
  plank->SetOrigin(1.5, 6, -0.4);
  plank->SetPoint1(0.6, 1.2, -0.2);
  plank->SetPoint2(1.5, 6, 0.4);
  stage.Add(plank);
  vtkLight* spot = stage.AddSpot(0, 4, 0.2, 55);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, spot, 0, technique.Bounds);
}

// An empty scene, then one that has something.
void CheckFilled(const rtwTechniqueCase& technique, rtwChain chain)
{
  Stage stage(technique, "empty before", chain);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  stage.AddObjects();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, technique.Bounds);
}
}

void rtwCheckTechnique(const rtwTechniqueCase& technique)
{
  for (const rtwChain chain : { rtwChain::Steps, rtwChain::Classic })
  {
    CheckFirstFrame(technique, chain, false);
    CheckFirstFrame(technique, chain, true);
    Stage lights(technique, "lights", chain);
    rtwCheckLights(lights, technique.Bounds);
    RTW_CHECK_PICTURE(lights);
    Stage glyphs(technique, "glyphs", chain);
    rtwCheckGlyphs(glyphs);
    CheckPlank(technique, chain);
    CheckFilled(technique, chain);
  }
}

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
    RTW_CHECK(stage.Pass->GetNumberOfCastersDrawn(i) > 0);
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
