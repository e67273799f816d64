// SPDX-License-Identifier: BSD-3-Clause
// Exact shadows of whole scenes, at 1024 × 1024 pixels, beside exact rays: next to no pixel is
// wrong.
//
// What remains is sorted. Most lies where a pixel shows another surface than the ray through its
// centre meets, of the fur ball nearly all, because so many of its pixels are edges of hairs: there
// the mask is right for what is drawn. The rest are edges of shadows that pass through a pixel's
// centre within rounding, and casters that touch the surface.
#include "rtwSceneStage.h"
#include "rtwTest.h"
#include "rtwWrongPixels.h"

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
  const rtwWrongPixels sorted =
    rtwSortWrongPixels(mask, stage.Truth, *stage.Reference, stage.Light);
  std::cout << each.Scene << ": " << errors.Percent(errors.Wrong()) << " % wrong ("
            << errors.WronglyDark << " dark, " << errors.WronglyLit << " lit), far from edges "
            << errors.FarFromEdge << " pixels, undecided " << errors.Percent(errors.NotComparable)
            << " %; of the wrong pixels " << sorted.OtherSurface << " show another surface, "
            << sorted.AtEdge << " are at an edge of the shadow, at " << sorted.NearSurface
            << " the caster touches the surface, " << sorted.Unexplained
            << " are unexplained; wrong shadows of what is drawn "
            << errors.Percent(sorted.WrongShadows()) << " %" << std::endl;
  RTW_CHECK(errors.Percent(errors.Wrong()) < each.Wrong);
  RTW_CHECK(errors.Percent(sorted.WrongShadows()) < 0.01);
  RTW_CHECK_EQUAL(sorted.Unexplained, 0);
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
