// SPDX-License-Identifier: BSD-3-Clause
// The very first frame has the right shadow, whatever the technique, chain and kind of light.
#include "rtwShadowStage.h"

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
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS(stage, light, 0);
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowFirstFrame(int, char*[])
{
  for (const Named& technique : { Named{ rtwTechnique::Unfocused, "unfocused" },
         Named{ rtwTechnique::Uniform, "uniform" }, Named{ rtwTechnique::RTW, "rtw" } })
  {
    TestOneFrame(technique, rtwChain::Steps, false);
    TestOneFrame(technique, rtwChain::Classic, true);
  }
  TestOneFrame({ rtwTechnique::RTW, "rtw" }, rtwChain::Classic, false);
  TestOneFrame({ rtwTechnique::RTW, "rtw" }, rtwChain::Steps, true);
  return rtwTestResult();
}
