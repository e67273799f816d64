// SPDX-License-Identifier: BSD-3-Clause
// What reaches from behind a lamp into its light casts with the part that is before it, by each
// technique.
#include "rtwShadowStage.h"

#include "vtkPlaneSource.h"

#include <string>

namespace
{
void TestPlank(rtwTechnique technique, const char* name, const rtwShadowBounds& bounds)
{
  rtwShadowStage stage(technique);
  stage.Name = std::string("beside a lamp, ") + name;
  stage.Options.Sharp = true;
  stage.AddFloor();
  vtkNew<vtkPlaneSource> plank;
  plank->SetOrigin(1.5, 6, -0.4);
  plank->SetPoint1(0.6, 1.2, -0.2);
  plank->SetPoint2(1.5, 6, 0.4);
  stage.Add(plank);
  vtkLight* spot = stage.AddSpot(0, 4, 0.2, 55);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, spot, 0, bounds);
}
}

int TestShadowBesideLamp(int, char*[])
{
  rtwShadowBounds maps;
  TestPlank(rtwTechnique::Uniform, "uniform", maps);
  TestPlank(rtwTechnique::RTW, "rtw", maps);
  TestPlank(rtwTechnique::NoTW, "notw", maps);
  TestPlank(rtwTechnique::Perspective, "perspective", maps);
  TestPlank(rtwTechnique::Cascades, "cascades", maps);
  TestPlank(rtwTechnique::Exact, "exact", { 0.01, 0.005, 0.1, 0.02, 2.0 });
  return rtwTestResult();
}
