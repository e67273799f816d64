// SPDX-License-Identifier: BSD-3-Clause
// Exact shadows of whole scenes, at 1024 × 1024 pixels, beside exact rays: next to no pixel is
// wrong.
//
// What remains lies where a pixel shows another surface than the ray through its centre meets, or
// where a shadow's edge passes through a pixel's centre within the rounding of floats. Of the fur
// ball the former are many, because so many of its pixels are edges of hairs.
#include "rtwOtherSurfaces.h"
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkExactShadowMapPass.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{
struct Case
{
  const char* Scene;
  double Wrong; // percent of the pixels that face the light
};

constexpr Case Cases[] = { { "town", 0.01 }, { "sandbox", 0.01 }, { "duel", 0.01 },
  { "terrain", 0.01 }, { "playground", 0.01 }, { "robot", 0.01 }, { "furball", 0.02 } };

void TestScene(const Case& each)
{
  rtwSceneStage stage(each.Scene, true);
  vtkNew<vtkExactShadowMapPass> pass;
  std::vector<unsigned char> mask;
  const rtw::ShadowErrors errors = stage.Measure(pass, 1, nullptr, nullptr, &mask);
  const int others = rtwCountOtherSurfaces(stage.Window, mask, stage.Truth);
  std::cout << each.Scene << ": " << errors.Percent(errors.Wrong()) << " % wrong ("
            << errors.WronglyDark << " dark, " << errors.WronglyLit << " lit), far from edges "
            << errors.FarFromEdge << " pixels, another surface at " << others << ", undecided "
            << errors.Percent(errors.NotComparable) << " %" << std::endl;
  RTW_CHECK(errors.Percent(errors.Wrong()) < each.Wrong);
  RTW_CHECK(errors.Percent(errors.Wrong() - others) < 0.01);
  RTW_CHECK(errors.Percent(errors.FarFromEdge) < 0.002);
  RTW_CHECK(errors.Percent(errors.NotComparable) < 0.05);
}
}

int TestExactAccuracy(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  int scenes = 0;
  for (const Case& each : Cases)
  {
    if (all || scenes < 4)
    {
      TestScene(each);
    }
    ++scenes;
  }
  return rtwTestResult();
}
