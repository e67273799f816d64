// SPDX-License-Identifier: BSD-3-Clause
// The turn of the light plane on whole scenes: what AUTOMATIC chooses has no more error than what
// lies there by itself, and where that is bad, about as little as in line with the scene.
#include "rtwRotatedScene.h"
#include "rtwSceneStage.h"
#include "rtwTest.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRTWShadowMapPass.h"
#include "vtkShadowRenderStepsPass.h"
#include "vtkSmartPointer.h"

#include <iostream>

namespace
{
// Of the first frame.
double Measure(rtwSceneStage& stage, int turn)
{
  vtkNew<vtkRTWShadowMapPass> pass;
  pass->SetLightPlaneTurn(turn);
  const rtw::ShadowErrors errors = stage.Measure(pass);
  return errors.Percent(errors.Wrong());
}

void TestNoWorse()
{
  for (const char* scene :
    { "town", "sandbox", "furball", "playground", "duel", "robot", "terrain" })
  {
    rtwSceneStage stage(scene);
    const double off = Measure(stage, vtkRTWShadowMapPass::TURN_OFF);
    const double automatic = Measure(stage, vtkRTWShadowMapPass::TURN_AUTOMATIC);
    std::cout << scene << ": " << off << " % wrong, automatic " << automatic << " %" << std::endl;
    RTW_CHECK(automatic <= 1.05 * off);
  }
}

// Rotating all there is about the light is to turn the plane the other way: from where walls lie in
// line with the map. Where texels are wider than triangles, neighbouring turns are told apart less
// well.
void TestRotated(const char* name, double most)
{
  const rtw::Scene scene = rtw::MakeScene(name);
  rtwSceneStage still(scene);
  const double inLine = Measure(still, vtkRTWShadowMapPass::TURN_OFF);
  for (const double degrees : { 30.0, 45.0 })
  {
    rtwSceneStage stage(rtw::RotatedAboutLight(scene, degrees));
    const double off = Measure(stage, vtkRTWShadowMapPass::TURN_OFF);
    const double automatic = Measure(stage, vtkRTWShadowMapPass::TURN_AUTOMATIC);
    std::cout << name << ", rotated by " << degrees << " degrees: " << off << " % wrong, automatic "
              << automatic << " %, in line " << inLine << " %" << std::endl;
    RTW_CHECK(off >= 1.3 * inLine); // else there is nothing to see
    RTW_CHECK(automatic <= most * inLine);
  }
}

// Each light is turned by its own errors: the second one, too, gets less than by 0.78 %, as it
// lies.
void TestSecondLight()
{
  rtwSceneStage stage(rtw::RotatedAboutLight(rtw::MakeScene("robot"), 30));
  const vtkSmartPointer<vtkLight> light =
    vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  stage.Renderer->RemoveLight(light);
  vtkNew<vtkLight> other;
  other->SetPosition(0.3, 1, 0.2);
  other->SetFocalPoint(0, 0, 0);
  stage.Renderer->AddLight(other);
  stage.Renderer->AddLight(light);
  vtkNew<vtkRTWShadowMapPass> pass;
  pass->SetLightPlaneTurnToAutomatic();
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(pass);
  stage.Renderer->SetPass(steps);
  stage.Window->Render();
  const rtw::ShadowErrors errors = rtw::Compare(rtw::MaskOf(pass->GetShadowMask(1)), stage.Truth);
  std::cout << "robot's light as the second: " << errors.Percent(errors.Wrong()) << " % wrong"
            << std::endl;
  RTW_CHECK(errors.Percent(errors.Wrong()) < 0.6);
  steps->ReleaseGraphicsResources(stage.Window);
  stage.Renderer->SetPass(nullptr);
}
}

int TestLightPlaneTurnScenes(int, char*[])
{
  TestNoWorse();
  TestSecondLight();
  TestRotated("robot", 1.05);
  TestRotated("terrain", 1.2);
  return rtwTestResult();
}
