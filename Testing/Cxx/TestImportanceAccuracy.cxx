// SPDX-License-Identifier: BSD-3-Clause
// Importance functions beside the default on whole scenes against exact rays, at 1024 × 1024
// pixels: each within 1.15 times, + 0.1, of what its parameterization can reach when every texel
// holds an exact ray.
//
// With the argument `all` every scene and resolution is measured, else what tells most in little
// time.
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkRTWShadowMapPass.h"

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using Pass = vtkRTWShadowMapPass;

struct Technique
{
  const char* Name;
  int Importance;
  int Analysis;
  int Limit; // of Case::Limits
};

constexpr int Published = Pass::DESIRED_VIEW | Pass::DISTANCE_TO_EYE | Pass::SURFACE_NORMAL;

constexpr Technique Techniques[] = {
  { "published at edges, hybrid", Published | Pass::SHADOW_EDGE, Pass::HYBRID, 0 },
  { "footprint", Pass::FOOTPRINT, Pass::BACKWARD, 1 },
  { "sample count", Pass::SAMPLE_COUNT, Pass::BACKWARD, 2 },
  { "demand at edges, hybrid", Pass::SQRT_DEMAND | Pass::SHADOW_EDGE, Pass::HYBRID, 3 },
  { "demand at edges, last mask", Pass::SQRT_DEMAND | Pass::SHADOW_EDGE, Pass::BACKWARD, 3 },
};

constexpr int Resolutions[] = { 512, 1024, 2048 };

// The least error that is possible, in percent of the pixels that face the light, for each
// resolution.
struct Limit
{
  double Nearest[3];
  double Bilinear[3];
};

struct Case
{
  const char* Scene;
  Limit Limits[4]; // published at edges, footprint, sample count, demand at edges
};

constexpr Case Cases[] = { { "town",
                             { { { 5.1328, 3.0168, 1.7611 }, { 4.7680, 2.7221, 1.5818 } },
                               { { 6.3850, 3.9825, 2.2931 }, { 6.0793, 3.6728, 2.0591 } },
                               { { 3.8469, 2.4784, 1.6923 }, { 3.5958, 2.2911, 1.5897 } },
                               { { 3.5242, 2.0886, 1.3146 }, { 3.2570, 1.8928, 1.2240 } } } },
  { "sandbox",
    { { { 6.0341, 5.6088, 4.9294 }, { 5.7750, 5.4269, 4.8441 } },
      { { 2.0455, 1.0257, 0.5246 }, { 1.7876, 0.8704, 0.4307 } },
      { { 1.8558, 0.9877, 0.5055 }, { 1.6352, 0.8500, 0.4353 } },
      { { 1.5252, 0.7612, 0.3873 }, { 1.2678, 0.6222, 0.3083 } } } },
  { "furball",
    { { { 4.2651, 2.5439, 1.3950 }, { 3.9682, 2.2440, 1.1702 } },
      { { 4.2569, 2.6071, 1.4528 }, { 3.9268, 2.3106, 1.2238 } },
      { { 5.3229, 3.4445, 1.9789 }, { 5.0124, 3.1455, 1.7138 } },
      { { 4.1027, 2.4715, 1.3540 }, { 3.7910, 2.1633, 1.1295 } } } },
  { "playground",
    { { { 0.9757, 0.4940, 0.2527 }, { 0.8087, 0.4016, 0.1961 } },
      { { 1.1273, 0.5810, 0.2944 }, { 0.9558, 0.4894, 0.2434 } },
      { { 1.5207, 0.7647, 0.3999 }, { 1.3372, 0.6565, 0.3422 } },
      { { 0.9321, 0.4607, 0.2336 }, { 0.7637, 0.3743, 0.1858 } } } },
  { "duel",
    { { { 3.9393, 1.9931, 1.0681 }, { 3.8818, 1.9656, 1.0496 } },
      { { 3.9787, 2.0082, 1.1260 }, { 3.9251, 1.9757, 1.1145 } },
      { { 3.3579, 2.0247, 1.1598 }, { 3.3111, 1.9971, 1.1449 } },
      { { 3.0066, 1.7671, 0.8957 }, { 2.9528, 1.7490, 0.8849 } } } },
  { "robot",
    { { { 1.2777, 0.7443, 0.4098 }, { 1.1364, 0.6690, 0.3715 } },
      { { 1.6004, 0.6863, 0.3507 }, { 1.4375, 0.6059, 0.3126 } },
      { { 1.0367, 0.5489, 0.2811 }, { 0.9390, 0.5063, 0.2577 } },
      { { 0.9005, 0.4658, 0.2365 }, { 0.8066, 0.4169, 0.2124 } } } } };

void Measure(rtwSceneStage& stage, const Technique& technique, const Limit& limit, int resolution,
  bool bilinear)
{
  vtkNew<Pass> pass;
  pass->SetImportance(technique.Importance);
  pass->SetAnalysis(technique.Analysis);
  pass->SetResolution(static_cast<unsigned int>(Resolutions[resolution]));
  pass->SetFilter(bilinear ? Pass::BILINEAR : Pass::NEAREST);
  // The first frame knows no mask.
  const bool needsMask =
    technique.Analysis == Pass::BACKWARD && (technique.Importance & Pass::SHADOW_EDGE);
  const rtw::ShadowErrors errors = stage.Measure(pass, needsMask ? 2 : 1);
  const double wrong = errors.Percent(errors.Wrong());
  const double least = (bilinear ? limit.Bilinear : limit.Nearest)[resolution];
  std::printf("%-11s %-27s %5d %-8s %8.4f wrong %8.4f limit %8.4f bound\n", stage.Name.c_str(),
    technique.Name, Resolutions[resolution], bilinear ? "bilinear" : "nearest", wrong, least,
    1.15 * least + 0.1);
  std::fflush(stdout);
  RTW_CHECK(wrong <= 1.15 * least + 0.1);
  RTW_CHECK(errors.Percent(errors.NotComparable) < 0.05);
}

void MeasureAll(const Case& each)
{
  rtwSceneStage stage(each.Scene);
  for (const Technique& technique : Techniques)
  {
    for (int resolution = 0; resolution < 3; ++resolution)
    {
      Measure(stage, technique, each.Limits[technique.Limit], resolution, false);
      Measure(stage, technique, each.Limits[technique.Limit], resolution, true);
    }
  }
}
}

int TestImportanceAccuracy(int argc, char* argv[])
{
  const bool all = argc > 1 && std::string(argv[argc - 1]) == "all";
  for (const Case& each : Cases)
  {
    if (all)
    {
      MeasureAll(each);
    }
    else if (each.Scene == std::string("playground"))
    {
      rtwSceneStage stage(each.Scene);
      for (const Technique& technique : Techniques)
      {
        if (technique.Importance & Pass::SHADOW_EDGE)
        {
          Measure(stage, technique, each.Limits[technique.Limit], 1, false);
        }
      }
    }
  }
  return rtwTestResult();
}
