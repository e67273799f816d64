// SPDX-License-Identifier: BSD-3-Clause
// Users' functions that don't compile or give no numbers, and values that are none.
#include "rtwImportanceScene.h"

#include "vtkRectilinearShadowMapWarp.h"

#include <limits>
#include <sstream>

namespace
{
using Pass = vtkRTWShadowMapPass;
using Maps = rtwImportanceScene::Maps;

const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

int ErrorsAfter(rtwImportanceScene& scene, const char* code, rtwMessageCatcher& messages)
{
  const int before = messages.GetNumberOfErrors();
  scene.Warped->SetUserFunction(code);
  scene.Render();
  scene.Render();
  return messages.GetNumberOfErrors() - before;
}

void TestBadFunction()
{
  rtwImportanceScene scene;
  vtkLight* sun = scene.AddSun(1, 10, 1);
  rtwShadowBounds bounds;
  bounds.Shadowed = 0.5;
  const Maps view = scene.MapsWith(Pass::DESIRED_VIEW);
  scene.Warped->SetImportance(Pass::USER_FUNCTION);
  rtwMessageCatcher messages(scene.Warped->GetRectilinearWarp());
  RTW_CHECK_EQUAL(ErrorsAfter(scene, "depth +", messages), 1);
  rtwCheckAlike("nothing good yet", scene.GetMaps(), view);
  RTW_CHECK_EQUAL(ErrorsAfter(scene, "1.0 / (depth * depth)", messages), 0);
  const Maps good = scene.GetMaps();
  rtwCheckApart("a good one", good, view);
  RTW_CHECK_EQUAL(
    ErrorsAfter(scene, "float a = depth;\nfloat b = a;\nreturn a * nothing;", messages), 1);
  rtwCheckAlike("the last good one", scene.GetMaps(), good);
  const std::string text = messages.GetText();
  // Mesa and NVIDIA write the source's number and the line in their own ways.
  RTW_CHECK(text.find("0:3(") != std::string::npos || text.find("0(3)") != std::string::npos);
  for (const char* part : { "UserFunction", "a * nothing", "SetUserFunction()" })
  {
    rtwCheck(text.find(part) != std::string::npos, __FILE__, __LINE__, part);
  }
  // Another shape of the code keeps the function that is in force.
  scene.Warped->SetImportance(Pass::USER_FUNCTION | Pass::SHADOW_EDGE);
  scene.Warped->SetEdgeThreshold(0);
  scene.Warped->SetAnalysisToHybrid();
  scene.Render();
  rtwCheckAlike("still the last good one", scene.GetMaps(), good);
  scene.Warped->SetAnalysisToBackward();
  scene.Warped->SetImportance(Pass::USER_FUNCTION);
  for (const char* code : { "}", "#version 100\n1.0", "vec2(1.0)", "while (true" })
  {
    RTW_CHECK_EQUAL(ErrorsAfter(scene, code, messages), 1);
    rtwCheckAlike(code, scene.GetMaps(), good);
  }
  for (const char* code : { "sqrt(-depth)", "-1.0", "1e38 * depth", "0.0", "log(-1.0) * 0.0" })
  {
    RTW_CHECK_EQUAL(ErrorsAfter(scene, code, messages), 0);
    scene.Name = code;
    RTW_CHECK_SHADOWS_WITHIN(scene, sun, 0, bounds);
  }
  RTW_CHECK_EQUAL(ErrorsAfter(scene, nullptr, messages), 0);
  rtwCheckAlike("null", scene.GetMaps(), view);
  RTW_CHECK_EQUAL(std::string(scene.Warped->GetUserFunction()), std::string());
}

// Two passes compile the function of one warp; it is said once.
void TestSharedWarp()
{
  rtwImportanceScene one, other;
  one.AddSun(0, 10, 0);
  other.AddSun(0, 10, 0);
  vtkNew<vtkRectilinearShadowMapWarp> warp;
  warp->SetImportance(vtkRectilinearShadowMapWarp::USER_FUNCTION);
  warp->SetUserFunction("depth depth");
  one.Warped->SetWarp(warp);
  other.Warped->SetWarp(warp);
  rtwMessageCatcher messages(warp);
  one.Render();
  other.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 1);
}

void TestBadValues()
{
  vtkNew<Pass> pass;
  rtwMessageCatcher messages(pass->GetRectilinearWarp());
  int expected = 0;
  const auto refused = [&](const char* what) {
    ++expected;
    rtwCheck(messages.GetNumberOfErrors() == expected, __FILE__, __LINE__, what);
  };
  pass->SetImportance(512);
  refused("Importance 512");
  pass->SetAnalysis(3);
  refused("Analysis 3");
  pass->SetAnalysis(-1);
  refused("Analysis -1");
  pass->SetInterest(2);
  refused("Interest 2");
  pass->SetEdgeThreshold(NotANumber);
  refused("EdgeThreshold");
  pass->SetSurfaceNormalBonus(NotANumber);
  refused("SurfaceNormalBonus");
  pass->SetInterestCentre(0, Infinity, 0);
  refused("InterestCentre");
  pass->SetInterestRadius(Infinity);
  refused("InterestRadius");
  pass->SetInterestViewRadius(NotANumber);
  refused("InterestViewRadius");
  pass->SetInterestBonus(NotANumber);
  refused("InterestBonus");
  pass->SetTemporalBlending(NotANumber);
  refused("TemporalBlending");
  RTW_CHECK_EQUAL(pass->GetAnalysis(), int(Pass::BACKWARD));
  RTW_CHECK_EQUAL(pass->GetInterest(), int(Pass::VIEW));
  RTW_CHECK_EQUAL(pass->GetEdgeThreshold(), 0.001);
  RTW_CHECK_EQUAL(pass->GetSurfaceNormalBonus(), 2.0);
  RTW_CHECK_EQUAL(pass->GetInterestCentre()[1], 0.0);
  pass->SetLightImageResolution(1);
  RTW_CHECK_EQUAL(pass->GetLightImageResolution(), 16);
  pass->SetLightImageResolution(1 << 20);
  RTW_CHECK_EQUAL(pass->GetLightImageResolution(), 8192);
  pass->SetEdgeThreshold(-1);
  RTW_CHECK_EQUAL(pass->GetEdgeThreshold(), 0.0);
  pass->SetSurfaceNormalBonus(1e9);
  RTW_CHECK_EQUAL(pass->GetSurfaceNormalBonus(), 1000.0);
  pass->SetInterestRadius(-2);
  RTW_CHECK_EQUAL(pass->GetInterestRadius(), 1e-30);
  pass->SetInterestViewRadius(100);
  RTW_CHECK_EQUAL(pass->GetInterestViewRadius(), 10.0);
  pass->SetInterestBonus(-1);
  RTW_CHECK_EQUAL(pass->GetInterestBonus(), 0.0);
  RTW_CHECK_EQUAL(pass->GetTemporalBlending(), 0.0);
  pass->SetTemporalBlending(1);
  RTW_CHECK_EQUAL(pass->GetTemporalBlending(), 0.99);
  pass->SetTemporalBlending(-1);
  RTW_CHECK_EQUAL(pass->GetTemporalBlending(), 0.0);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), expected);
  RTW_CHECK(!pass->GetSnapping() && !pass->GetCullEmptyCells());
  pass->SnappingOn();
  pass->CullEmptyCellsOn();
  RTW_CHECK(pass->GetSnapping() && pass->GetCullEmptyCells());
  std::ostringstream text;
  pass->GetRectilinearWarp()->Print(text);
  for (const char* name : { "Analysis: 1", "LightImageResolution: 8192", "EdgeThreshold: 0",
         "SurfaceNormalBonus: 1000", "Interest: 0", "InterestCentre: 0, 0, 0",
         "InterestRadius: 1e-30", "InterestViewRadius: 10", "InterestBonus: 0",
         "UserFunction: ", "TemporalBlending: 0", "Snapping: 1", "CullEmptyCells: 1" })
  {
    rtwCheck(text.str().find(name) != std::string::npos, __FILE__, __LINE__, name);
  }
}
}

int TestImportanceBadInput(int, char*[])
{
  TestBadFunction();
  TestSharedWarp();
  TestBadValues();
  return rtwTestResult();
}
