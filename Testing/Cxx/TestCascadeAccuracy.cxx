// SPDX-License-Identifier: BSD-3-Clause
// Cascades against exact rays, at 1024 × 1024 pixels: within 1.15 times, + 0.1, of what the same
// cascades reach when every texel holds an exact ray; a decision by the nearest texel, and by four.
// With the argument "all" six scenes at two resolutions.
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkCascadedShadowMapPass.h"
#include "vtkRectilinearShadowMapWarp.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{
struct Limits
{
  double Nearest, Bilinear; // percent of the pixels that face the light
};

struct Technique
{
  const char* Name;
  int Layers;
  int Scheme;
  bool Warped;
};

constexpr Technique Techniques[] = {
  { "logarithmic", 4, vtkCascadedShadowMapPass::LOGARITHMIC, false },
  { "practical", 4, vtkCascadedShadowMapPass::PRACTICAL, false },
  { "2 x RTW", 2, vtkCascadedShadowMapPass::LOGARITHMIC, true },
  { "4 x RTW", 4, vtkCascadedShadowMapPass::LOGARITHMIC, true },
};

struct Case
{
  const char* Scene;
  Limits At512[4], At1024[4]; // of Techniques
};

constexpr Case Cases[] = {
  { "town", { { 2.7250, 2.4200 }, { 7.7226, 7.3260 }, { 3.1437, 2.8979 }, { 2.2358, 2.0097 } },
    { { 1.5694, 1.3780 }, { 4.5198, 4.1597 }, { 1.8729, 1.7057 }, { 1.3402, 1.2099 } } },
  { "duel", { { 3.8064, 3.7530 }, { 8.7637, 8.6691 }, { 3.1709, 3.1373 }, { 2.3593, 2.3360 } },
    { { 1.8708, 1.8457 }, { 4.9544, 4.8907 }, { 1.7867, 1.7657 }, { 1.3335, 1.3175 } } },
  { "sandbox", { { 1.0554, 0.8416 }, { 1.0535, 0.8480 }, { 1.0648, 0.8648 }, { 0.8613, 0.6925 } },
    { { 0.5307, 0.4182 }, { 0.5498, 0.4342 }, { 0.5308, 0.4185 }, { 0.4177, 0.3261 } } },
  { "furball", { { 5.3615, 5.0507 }, { 5.3886, 5.0832 }, { 4.9840, 4.6612 }, { 4.7580, 4.4446 } },
    { { 3.5112, 3.1949 }, { 3.4830, 3.1906 }, { 3.1492, 2.8372 }, { 2.9783, 2.6858 } } },
  { "playground",
    { { 0.8040, 0.6419 }, { 0.9983, 0.8145 }, { 1.1461, 0.9678 }, { 0.7101, 0.5734 } },
    { { 0.4093, 0.3272 }, { 0.5076, 0.4008 }, { 0.5952, 0.4831 }, { 0.3745, 0.2967 } } },
  { "robot", { { 1.1265, 1.0097 }, { 1.1034, 0.9757 }, { 0.8231, 0.7368 }, { 0.6175, 0.5631 } },
    { { 0.6362, 0.5745 }, { 0.5832, 0.5261 }, { 0.4274, 0.3825 }, { 0.3105, 0.2815 } } },
};

void TestTechnique(
  rtwSceneStage& stage, const Technique& technique, unsigned int resolution, const Limits& limits)
{
  vtkNew<vtkCascadedShadowMapPass> pass;
  pass->SetNumberOfLayers(technique.Layers);
  pass->SetSplitScheme(technique.Scheme);
  pass->SetResolution(resolution);
  if (technique.Warped)
  {
    vtkNew<vtkRectilinearShadowMapWarp> warp;
    pass->SetWarp(warp);
  }
  for (const bool isNearest : { true, false })
  {
    pass->SetFilter(
      isNearest ? vtkCascadedShadowMapPass::NEAREST : vtkCascadedShadowMapPass::BILINEAR);
    const rtw::ShadowErrors errors = stage.Measure(pass);
    const double limit = isNearest ? limits.Nearest : limits.Bilinear;
    const double wrong = errors.Percent(errors.Wrong());
    std::cout << stage.Name << " " << resolution << " " << technique.Name
              << (isNearest ? " nearest: " : " bilinear: ") << wrong << " % wrong, limit " << limit
              << ", " << wrong / limit << " times; far " << errors.Percent(errors.FarFromEdge)
              << std::endl;
    RTW_CHECK(errors.Percent(errors.NotComparable) < 0.05);
    RTW_CHECK(wrong <= 1.15 * limit + 0.1);
  }
}
}

int TestCascadeAccuracy(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  int scenes = 0;
  for (const Case& each : Cases)
  {
    if (!all && scenes++ == 2)
    {
      break;
    }
    rtwSceneStage stage(each.Scene);
    for (std::size_t i = 0; i < std::size(Techniques); ++i)
    {
      TestTechnique(stage, Techniques[i], 1024, each.At1024[i]);
      if (all)
      {
        TestTechnique(stage, Techniques[i], 512, each.At512[i]);
      }
    }
  }
  return rtwTestResult();
}
