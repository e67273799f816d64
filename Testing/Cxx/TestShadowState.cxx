// SPDX-License-Identifier: BSD-3-Clause
// Whatever state OpenGL is in when a stage of any technique begins, it is in when the stage ends,
// piece by piece, and what the stage finds out is what it finds in the usual state. VTK's record of
// the state stays true, and OpenGL notes no error.
#include "rtwStateSnapshot.h"
#include "rtwWatchedStage.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double MOST_DIFFERENT = 0.01; // of the pixels: choices may come a frame sooner or later

std::vector<unsigned char> DrawTwice(rtwWatchedStage& watched, bool odd)
{
  watched.Pass->SetCaching(false);
  watched.Render("first frame", odd);
  watched.Render("second frame", odd);
  watched.Pass->SetCaching(true);
  return watched.Stage.GetMask(0);
}

void TestTechnique(rtwTechnique technique, const std::string& name)
{
  rtwWatchedStage watched(technique, name);
  const std::vector<unsigned char> odd = DrawTwice(watched, true);
  watched.Render("third frame");
  watched.Render("still frame");
  RTW_CHECK(watched.Pass->GetNumberOfLayersReused() > 0 || technique == rtwTechnique::Exact);
  watched.CheckReadOuts();
  watched.CheckDebugViews();

  rtwWatchedStage usual(technique, name + ", usual state");
  const std::vector<unsigned char> expected = DrawTwice(usual, false);
  RTW_CHECK(std::count(expected.begin(), expected.end(), 0) > 20);
  RTW_CHECK_EQUAL(odd.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < std::min(odd.size(), expected.size()); ++i)
  {
    different += odd[i] != expected[i];
  }
  rtwCheck(double(different) <= MOST_DIFFERENT * double(expected.size()), __FILE__, __LINE__,
    name + ": the mask is that of the usual state, but for " + std::to_string(different) +
      " pixels");
}
}

int TestShadowState(int, char*[])
{
  {
    rtwShadowStage stage;
    stage.Render();
    if (!rtwCanTellState())
    {
      return rtwTestSkipped;
    }
  }
  const std::pair<rtwTechnique, const char*> techniques[] = {
    { rtwTechnique::Unfocused, "unfocused" }, { rtwTechnique::Uniform, "uniform" },
    { rtwTechnique::RTW, "rtw" }, { rtwTechnique::NoTW, "notw" },
    { rtwTechnique::Perspective, "perspective" }, { rtwTechnique::Cascades, "cascades" },
    { rtwTechnique::Exact, "exact" } };
  for (const auto& [technique, name] : techniques)
  {
    TestTechnique(technique, name);
  }
  return rtwTestResult();
}
