// SPDX-License-Identifier: BSD-3-Clause
// As TestShadowState, of all settings that draw by other programs or into other targets.
#include "rtwStateSnapshot.h"
#include "rtwWatchedStage.h"

#include <string>

namespace
{
using Pass = vtkAdaptiveShadowMapPass;

void TestSamples(rtwTechnique technique, const std::string& name)
{
  rtwWatchedStage watched(technique, name + ", 4 samples", 4);
  watched.Render("first frame");
  watched.Render("still frame");
  watched.CheckReadOuts();
  watched.CheckDebugViews();
}

void TestSettings()
{
  rtwWatchedStage watched(rtwTechnique::RTW, "rtw");
  watched.Pass->SetTimeStages(true);
  for (const int filter : { Pass::NEAREST, Pass::PCF, Pass::SOFT })
  {
    watched.Pass->SetFilter(filter);
    watched.Render("filter " + std::to_string(filter));
  }
  watched.Pass->SetFilter(Pass::BILINEAR);
  for (const int rasterization : { Pass::LINEAR, Pass::TESSELLATED, Pass::EXACT })
  {
    watched.Pass->SetRasterization(rasterization);
    watched.Render("rasterization " + std::to_string(rasterization));
  }
  for (const int turn :
    { Pass::TURN_VIEW_ALIGNED, Pass::TURN_AUTOMATIC, Pass::TURN_MINIMAL_FRUSTUM })
  {
    watched.Pass->SetLightPlaneTurn(turn);
    watched.Render("turn " + std::to_string(turn));
    watched.Render("turn " + std::to_string(turn) + ", next frame");
  }
  watched.Pass->SetFocusOnView(false);
  watched.Render("unfocused");
  RTW_CHECK(watched.Pass->GetNumberOfStages() > 3);
}

void TestPreviousFrame(rtwTechnique technique, const std::string& name)
{
  rtwWatchedStage watched(technique, name + ", previous frame");
  watched.Pass->SetViewSampleSource(Pass::PREVIOUS_FRAME);
  watched.Pass->SetCaching(false);
  for (int frame = 0; frame < 3; ++frame)
  {
    watched.Render("frame " + std::to_string(frame));
  }
  watched.CheckReadOuts();
}
}

int TestShadowStateSettings(int, char*[])
{
  {
    rtwShadowStage stage;
    stage.Render();
    if (!rtwCanTellState())
    {
      return rtwTestSkipped;
    }
  }
  TestSamples(rtwTechnique::RTW, "rtw");
  TestSamples(rtwTechnique::Exact, "exact");
  TestSettings();
  TestPreviousFrame(rtwTechnique::RTW, "rtw");
  TestPreviousFrame(rtwTechnique::Cascades, "cascades");
  return rtwTestResult();
}
