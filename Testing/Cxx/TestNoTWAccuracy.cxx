// SPDX-License-Identifier: BSD-3-Clause
// Non-orthogonal texture warping against exact rays, at 1024 × 1024 pixels: within 1.15 times, +
// 0.1, of what the better of its published parameterizations can reach when every texel holds an
// exact ray; and beside rectilinear texture warping. With the argument "all" six scenes at three
// resolutions.
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkNoTWShadowMapPass.h"
#include "vtkRTWShadowMapPass.h"

#include <iostream>
#include <string>

namespace
{
constexpr unsigned int Resolutions[] = { 512, 1024, 2048 };

struct Case
{
  const char* Scene;
  double Limits[3]; // percent of the pixels that face the light
};

constexpr Case Cases[] = {
  { "town", { 3.0415, 1.8612, 1.2110 } },
  { "sandbox", { 1.5250, 0.7943, 0.4138 } },
  { "duel", { 2.9242, 1.5794, 0.8700 } },
  { "furball", { 4.9899, 3.2375, 1.8288 } },
  { "playground", { 1.0940, 0.5821, 0.2982 } },
  { "robot", { 0.8387, 0.4590, 0.2508 } },
};

struct Result
{
  double Wrong, Far;
};

Result Measure(rtwSceneStage& stage, vtkAdaptiveShadowMapPass* pass, unsigned int resolution)
{
  pass->SetResolution(resolution);
  const rtw::ShadowErrors errors = stage.Measure(pass);
  RTW_CHECK(errors.Percent(errors.NotComparable) < 0.05);
  return { errors.Percent(errors.Wrong()), errors.Percent(errors.FarFromEdge) };
}

// Whether it has less error than rectilinear warping.
bool TestScene(rtwSceneStage& stage, unsigned int resolution, double limit)
{
  vtkNew<vtkNoTWShadowMapPass> notw;
  vtkNew<vtkRTWShadowMapPass> rtw;
  const Result own = Measure(stage, notw, resolution);
  const Result other = Measure(stage, rtw, resolution);
  std::cout << stage.Name << " " << resolution << ": " << own.Wrong << " % wrong, limit " << limit
            << "; far " << own.Far << "; rtw " << other.Wrong << ", far " << other.Far
            << std::endl;
  RTW_CHECK(own.Wrong <= 1.15 * limit + 0.1);
  RTW_CHECK(own.Far < 0.12);
  return own.Wrong < other.Wrong;
}
}

int TestNoTWAccuracy(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[1]) == "all";
  int better = 0, scenes = 0;
  for (const Case& each : Cases)
  {
    if (!all && scenes == 3)
    {
      break;
    }
    rtwSceneStage stage(each.Scene);
    ++scenes;
    for (int i = all ? 0 : 1; i < (all ? 3 : 2); ++i)
    {
      const bool isBetter = TestScene(stage, Resolutions[i], each.Limits[i]);
      better += Resolutions[i] == 1024 && isBetter;
    }
  }
  RTW_CHECK(2 * better > scenes);
  return rtwTestResult();
}
