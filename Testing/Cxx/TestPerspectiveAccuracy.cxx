// SPDX-License-Identifier: BSD-3-Clause
// Light-space perspective shadow maps against exact rays, at 1024 × 1024 pixels: within 1.15 times,
// + 0.1, of what the parameterization can reach when every texel holds an exact ray. With the
// argument "all" six scenes at two resolutions.
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkPerspectiveShadowMapPass.h"

#include <iostream>
#include <string>

namespace
{
constexpr unsigned int Resolutions[] = { 512, 1024 };

// In percent of the pixels that face the light, of each resolution.
struct Case
{
  const char* Scene;
  double Nearest[2];
  double Bilinear[2];
};

constexpr Case Cases[] = {
  { "town", { 5.9865, 3.5778 }, { 5.6763, 3.2762 } },
  { "sandbox", { 2.1200, 1.0648 }, { 1.7550, 0.8489 } },
  { "duel", { 15.9565, 12.0417 }, { 15.4919, 11.9065 } },
  { "furball", { 6.3943, 4.5665 }, { 6.0614, 4.2657 } },
  { "playground", { 1.9499, 1.0320 }, { 1.7092, 0.8713 } },
  { "robot", { 2.4766, 1.2406 }, { 2.2473, 1.1138 } },
};

void Test(rtwSceneStage& stage, unsigned int resolution, bool filtered, double limit)
{
  vtkNew<vtkPerspectiveShadowMapPass> pass;
  pass->SetResolution(resolution);
  pass->SetFilter(
    filtered ? vtkAdaptiveShadowMapPass::BILINEAR : vtkAdaptiveShadowMapPass::NEAREST);
  const rtw::ShadowErrors errors = stage.Measure(pass);
  const double wrong = errors.Percent(errors.Wrong());
  std::cout << stage.Name << " " << resolution << (filtered ? " bilinear: " : " nearest: ") << wrong
            << " % wrong, limit " << limit << ", factor " << wrong / limit << "; far "
            << errors.Percent(errors.FarFromEdge) << std::endl;
  RTW_CHECK(errors.Percent(errors.NotComparable) < 0.05);
  RTW_CHECK(wrong <= 1.15 * limit + 0.1);
}
}

int TestPerspectiveAccuracy(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  int scenes = 0;
  for (const Case& each : Cases)
  {
    if (!all && scenes++ == 3)
    {
      break;
    }
    rtwSceneStage stage(each.Scene);
    for (int i = all ? 0 : 1; i < 2; ++i)
    {
      Test(stage, Resolutions[i], false, each.Nearest[i]);
      Test(stage, Resolutions[i], true, each.Bilinear[i]);
    }
  }
  return rtwTestResult();
}
