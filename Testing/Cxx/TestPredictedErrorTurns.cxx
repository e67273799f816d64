// SPDX-License-Identifier: BSD-3-Clause
// Turns of the light plane by predicted error beside exact rays: the one that is predicted to be
// best is about that, and where turns differ much, what is much worse is predicted to be worse.
#include "rtwRotatedScene.h"
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkRTWShadowMapPass.h"

#include <algorithm>
#include <iostream>
#include <vector>

namespace
{
constexpr int Turns = 4; // of a right angle

struct Turned
{
  double True, Predicted;
};

// Rotating all there is about the light is to turn the plane the other way.
std::vector<Turned> Measure(const char* name)
{
  const rtw::Scene scene = rtw::MakeScene(name);
  std::vector<Turned> turns;
  for (int i = 0; i < Turns; ++i)
  {
    rtwSceneStage stage(rtw::RotatedAboutLight(scene, -90.0 * i / Turns));
    vtkNew<vtkRTWShadowMapPass> pass;
    double predicted = -1;
    const rtw::ShadowErrors errors = stage.Measure(pass, 1, &predicted);
    turns.push_back({ errors.Percent(errors.Wrong()), 100 * predicted });
    std::cout << name << ", turned by " << 90.0 * i / Turns << " degrees: " << turns.back().True
              << " % wrong, " << turns.back().Predicted << " % predicted" << std::endl;
  }
  return turns;
}
}

int TestPredictedErrorTurns(int, char*[])
{
  // In others turns differ by less than a tenth.
  for (const char* scene : { "town", "furball", "robot", "terrain" })
  {
    const std::vector<Turned> turns = Measure(scene);
    const auto isBetter = [](const Turned& a, const Turned& b) { return a.True < b.True; };
    const auto isPredicted = [](const Turned& a, const Turned& b) {
      return a.Predicted < b.Predicted;
    };
    const Turned best = *std::min_element(turns.begin(), turns.end(), isBetter);
    const Turned chosen = *std::min_element(turns.begin(), turns.end(), isPredicted);
    RTW_CHECK(chosen.True <= 1.15 * best.True);
    for (const Turned& turn : turns)
    {
      RTW_CHECK(turn.True < 1.3 * best.True || turn.Predicted > 1.05 * chosen.Predicted);
    }
  }
  return rtwTestResult();
}
