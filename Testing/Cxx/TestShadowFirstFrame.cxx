// SPDX-License-Identifier: BSD-3-Clause
// The very first frame has the right shadow, whatever the technique, chain and kind of light.
#include "rtwDebugViews.h"

#include "vtkLightCollection.h"

namespace
{
struct Named
{
  rtwTechnique Technique;
  const char* Name;
};

void TestOneFrame(const Named& technique, rtwChain chain, bool spot)
{
  rtwShadowStage stage(technique.Technique, chain);
  stage.Name = std::string(technique.Name) + (chain == rtwChain::Classic ? " classic" : " steps") +
    (spot ? " spot" : " sun");
  stage.AddObjects();
  vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 1);
  RTW_CHECK_EQUAL(
    stage.Pass->GetNumberOfLayersDrawn(), technique.Technique == rtwTechnique::Cascades ? 4 : 1);
  RTW_CHECK_SHADOWS(stage, light, 0);
  RTW_CHECK_PICTURE(stage);
}

// Also of what only VTK's own mappers draw, before any light has been set up.
void TestGlyphs(rtwChain chain)
{
  rtwShadowStage stage(rtwTechnique::RTW, chain);
  stage.Name = chain == rtwChain::Classic ? "glyphs classic" : "glyphs steps";
  rtwFillForDebugViews(stage);
  stage.Render();
  auto* sun = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  RTW_CHECK_SHADOWS(stage, sun, 0);
}
}

int TestShadowFirstFrame(int, char*[])
{
  for (const Named& technique : { Named{ rtwTechnique::Unfocused, "unfocused" },
         Named{ rtwTechnique::Uniform, "uniform" }, Named{ rtwTechnique::RTW, "rtw" },
         Named{ rtwTechnique::NoTW, "notw" }, Named{ rtwTechnique::Perspective, "perspective" },
         Named{ rtwTechnique::Exact, "exact" }, Named{ rtwTechnique::Cascades, "cascades" } })
  {
    TestOneFrame(technique, rtwChain::Steps, false);
    TestOneFrame(technique, rtwChain::Classic, true);
  }
  TestOneFrame({ rtwTechnique::RTW, "rtw" }, rtwChain::Classic, false);
  TestOneFrame({ rtwTechnique::RTW, "rtw" }, rtwChain::Steps, true);
  TestGlyphs(rtwChain::Steps);
  TestGlyphs(rtwChain::Classic);
  return rtwTestResult();
}
