// SPDX-License-Identifier: BSD-3-Clause
// The turn of the light plane: shadows are as right as ever, the plane lies as it says, and an
// automatic choice is that of its twin and comes to rest.
#include "rtwEdgeTwin.h"
#include "rtwShadowStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowRenderStepsPass.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{
constexpr int Off = vtkAdaptiveShadowMapPass::TURN_OFF;
constexpr int View = vtkAdaptiveShadowMapPass::TURN_VIEW_ALIGNED;
constexpr int Automatic = vtkAdaptiveShadowMapPass::TURN_AUTOMATIC;

void Check(rtwShadowStage& stage, vtkLight* light, int index = 0, double wrong = 0.15)
{
  rtwShadowBounds bounds;
  bounds.Wrong = wrong;
  bounds.Shadowed = 0.5;
  RTW_CHECK_SHADOWS_WITHIN(stage, light, index, bounds);
}

glm::dvec2 OnPlane(vtkAdaptiveShadowMapPass* pass, int light, const glm::dvec3& world)
{
  vtkNew<vtkMatrix4x4> matrix;
  RTW_CHECK(pass->GetLightPlaneMatrix(light, 0, matrix));
  const double p[4] = { world.x, world.y, world.z, 1 };
  double q[4];
  matrix->MultiplyPoint(p, q);
  return glm::dvec2(q[0], q[1]) / q[3];
}

// Whether what the camera looks along runs along t on a light's map.
void CheckAligned(rtwShadowStage& stage, int light)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  glm::dvec3 eye, forward;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&forward.x);
  const double far = camera->GetDistance();
  const glm::dvec2 a = OnPlane(stage.Pass, light, eye + 0.6 * far * forward);
  const glm::dvec2 b = OnPlane(stage.Pass, light, eye + far * forward);
  std::cout << stage.Name << ", light " << light << ": the view runs from " << a.x << ", " << a.y
            << " to " << b.x << ", " << b.y << std::endl;
  RTW_CHECK_NEAR(a.x, b.x, 1e-4);
  RTW_CHECK(b.y > a.y + 0.01);
}

void TestSettings()
{
  rtwShadowStage stage;
  vtkAdaptiveShadowMapPass* pass = stage.Pass;
  RTW_CHECK_EQUAL(pass->GetLightPlaneTurn(), Off);
  pass->SetLightPlaneTurnToViewAligned();
  RTW_CHECK_EQUAL(pass->GetLightPlaneTurn(), View);
  rtwMessageCatcher messages(pass);
  pass->SetLightPlaneTurn(4);
  pass->SetLightPlaneTurn(-1);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 2);
  RTW_CHECK(
    messages.GetText().find("SetLightPlaneTurn(4): expected TURN_OFF") != std::string::npos);
  RTW_CHECK_EQUAL(pass->GetLightPlaneTurn(), View);
  pass->SetLightPlaneTurnToAutomatic();
  RTW_CHECK_EQUAL(pass->GetLightPlaneTurn(), Automatic);
  pass->SetLightPlaneTurnToOff();
  RTW_CHECK_EQUAL(pass->GetLightPlaneTurn(), Off);
}

// A directional light beside a spot, seen from here and there; a change of the turn draws maps
// anew, but builds no shaders.
void TestAligned(rtwTechnique technique, rtwChain chain)
{
  rtwShadowStage stage(technique, chain);
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkLight* spot = stage.AddSpot(-3, 7, 2, 40);
  stage.Render();
  const int builds = stage.Pass->GetNumberOfShaderBuilds();
  stage.Pass->SetLightPlaneTurn(View);
  for (int i = 0; i < 4; ++i)
  {
    stage.Name = "aligned " + std::to_string(i);
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 2);
    CheckAligned(stage, 0);
    CheckAligned(stage, 1);
    Check(stage, sun, 0, 0.25);
    Check(stage, spot, 1, 0.25);
    stage.Renderer->GetActiveCamera()->Azimuth(50);
    stage.Renderer->ResetCameraClippingRange();
  }
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShaderBuilds(), builds);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersReused(), 2);
  RTW_CHECK_PICTURE(stage);
  stage.Pass->SetLightPlaneTurn(Off);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 2);
  Check(stage, sun);
}

// Where the camera looks along the light there is nothing to align with.
void TestAlongTheLight()
{
  for (const bool spot : { false, true })
  {
    rtwShadowStage stage;
    stage.Name = spot ? "along a spot" : "along the sun";
    stage.AddObjects();
    vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 7, 2);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetPosition(3.6, 8.4, 2.4);
    camera->SetFocalPoint(0, 0, 0);
    stage.Render();
    const glm::dvec3 points[] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };
    std::vector<glm::dvec2> before;
    for (const glm::dvec3& point : points)
    {
      before.push_back(OnPlane(stage.Pass, 0, point));
    }
    stage.Pass->SetLightPlaneTurn(View);
    stage.Render();
    for (int i = 0; i < 3; ++i)
    {
      RTW_CHECK(glm::distance(OnPlane(stage.Pass, 0, points[i]), before[std::size_t(i)]) < 1e-6);
    }
    rtwShadowBounds bounds;
    bounds.Shadowed = 0;
    RTW_CHECK_SHADOWS_WITHIN(stage, light, 0, bounds);
    camera->Azimuth(3);
    stage.Render();
    RTW_CHECK(glm::distance(OnPlane(stage.Pass, 0, points[1]), before[1]) > 0.01);
    CheckAligned(stage, 0);
  }
}

// Posts in a row, under a low light, and a camera that looks neither along the row nor across.
void AddFence(rtwShadowStage& stage, double degrees)
{
  const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  for (int i = -6; i <= 6; ++i)
  {
    stage.AddBox(0.8 * i * c, 0.6, 0.8 * i * s, 0.5);
  }
}

// By the twin, of all turns that are compared.
void CheckChoice(rtwShadowStage& stage, vtkLight* light, int index)
{
  const int resolution = int(stage.Pass->GetResolution());
  const std::vector<rtw::TurnSample> samples =
    rtw::TurnSamplesOf(stage.Renderer, stage.Pass, light, index);
  const double chosen = rtw::TurnError(samples, 0, resolution, true);
  double least = chosen, most = chosen;
  for (int i = 0; i < 8; ++i)
  {
    const double error = rtw::TurnError(samples, glm::radians(11.25 * i), resolution, true);
    least = std::min(least, error);
    most = std::max(most, error);
  }
  std::cout << stage.Name << ", light " << index << ": errors of the turn " << chosen
            << ", of others " << least << " to " << most << std::endl;
  RTW_CHECK(chosen <= 1.05 * least / 0.9);
}

void TestAutomatic(rtwTechnique technique, rtwChain chain)
{
  rtwShadowStage stage(technique, chain);
  stage.AddFloor();
  AddFence(stage, 30);
  vtkLight* sun = stage.AddSun(3, 1.5, 2);
  vtkLight* spot = stage.AddSpot(-3, 7, 2, 40);
  stage.Pass->SetLightPlaneTurn(Automatic);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  for (int round = 0; round < 3; ++round)
  {
    stage.Name = "automatic " + std::to_string(round);
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 2);
    Check(stage, sun, 0, 0.3);
    Check(stage, spot, 1, 0.3);
    int drawn = 0;
    for (int frame = 0; frame < 4; ++frame)
    {
      stage.Render();
      drawn += stage.Pass->GetNumberOfLayersDrawn();
    }
    RTW_CHECK(drawn <= 2);
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 0);
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersReused(), 2);
    Check(stage, sun, 0, 0.3);
    Check(stage, spot, 1, 0.3);
    if (technique == rtwTechnique::RTW)
    {
      CheckChoice(stage, sun, 0);
      CheckChoice(stage, spot, 1);
    }
    camera->Azimuth(40);
    stage.Renderer->ResetCameraClippingRange();
  }
  stage.Render();
  RTW_CHECK_PICTURE(stage);
}

void AddBalls(rtwShadowStage& stage)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-2.5, 1, 1.5);
  points->InsertNextPoint(2.5, 1, 1.5);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetRadius(0.4f);
  vtkNew<vtkActor> balls;
  balls->SetMapper(mapper);
  stage.Renderer->AddActor(balls);
}

// Whatever else is set, shadows are right and frames come to rest.
void TestWithOthers()
{
  const std::vector<std::pair<const char*, std::function<void(rtwShadowStage&)>>> cases = {
    { "unfocused", [](rtwShadowStage& stage) { stage.Pass->FocusOnViewOff(); } },
    { "nearest", [](rtwShadowStage& stage) { stage.Pass->SetFilterToNearest(); } },
    { "previous frame",
      [](rtwShadowStage& stage) { stage.Pass->SetViewSampleSourceToPreviousFrame(); } },
    { "several samples", [](rtwShadowStage& stage) { stage.Window->SetMultiSamples(4); } },
    { "parallel",
      [](rtwShadowStage& stage) { stage.Renderer->GetActiveCamera()->ParallelProjectionOn(); } },
    { "mappers", [](rtwShadowStage& stage) { AddBalls(stage); } },
    { "tessellated",
      [](rtwShadowStage& stage) {
        stage.Pass->SetRasterizationToTessellated();
        stage.Pass->SetMaximumEdgeLength(0.01); // longer ones leak
      } },
    { "caching off", [](rtwShadowStage& stage) { stage.Pass->CachingOff(); } },
  };
  for (const auto& [name, set] : cases)
  {
    for (const int turn : { View, Automatic })
    {
      rtwShadowStage stage;
      stage.Name = std::string(name) + (turn == View ? ", aligned" : ", automatic");
      stage.AddObjects();
      vtkLight* sun = stage.AddSun(3, 5, 2);
      stage.Pass->SetLightPlaneTurn(turn);
      set(stage);
      for (int frame = 0; frame < 5; ++frame)
      {
        stage.Render();
      }
      const bool rests = stage.Pass->GetCaching();
      RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), rests ? 0 : 1);
      Check(stage, sun, 0, 0.3);
      RTW_CHECK_PICTURE(stage);
    }
  }
}

// Lights come and go, and so does what the driver holds.
void TestChanges()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Pass->SetLightPlaneTurn(Automatic);
  const auto check = [&](const char* name) {
    stage.Name = name;
    stage.Render();
    stage.Render();
    Check(stage, sun, 0, 0.25);
  };
  check("one light");
  vtkLight* spot = stage.AddSpot(-3, 7, 2, 40);
  check("two lights");
  Check(stage, spot, 1, 0.25);
  stage.Renderer->RemoveLight(spot);
  check("one again");
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  check("released");
  stage.Window->Finalize();
  check("new context");
  stage.Pass->SetLightPlaneTurn(Off);
  check("off");
  stage.Pass->SetLightPlaneTurn(Automatic);
  stage.Window->SetSize(60, 40);
  stage.Render();
  stage.Window->SetSize(320, 240);
  check("automatic again");
}

// The direction in the world of a map's s axis.
glm::dvec3 AxisOf(rtwShadowStage& stage)
{
  vtkNew<vtkMatrix4x4> matrix;
  RTW_CHECK(stage.Pass->GetLightPlaneMatrix(0, 0, matrix));
  return glm::normalize(
    glm::dvec3(matrix->GetElement(0, 0), matrix->GetElement(0, 1), matrix->GetElement(0, 2)));
}

// Seen from elsewhere the other turn is best.
vtkLight* AddFenceInSun(rtwShadowStage& stage, double azimuth)
{
  stage.AddFloor();
  AddFence(stage, 30);
  stage.Pass->SetLightPlaneTurn(Automatic);
  stage.Renderer->GetActiveCamera()->Azimuth(azimuth);
  stage.Renderer->ResetCameraClippingRange();
  return stage.AddSun(3, 1.5, 2);
}

glm::dvec3 AxisForFenceAlone(double azimuth)
{
  rtwShadowStage stage;
  AddFenceInSun(stage, azimuth);
  for (int frame = 0; frame < 4; ++frame)
  {
    stage.Render();
  }
  return AxisOf(stage);
}

// One pass for two renderers: the choice for one is not that for the other.
void TestSharedPass()
{
  const double azimuths[] = { 0, 170 };
  const glm::dvec3 alone[] = { AxisForFenceAlone(azimuths[0]),
    AxisForFenceAlone(azimuths[1]) };
  RTW_CHECK(glm::distance(alone[0], alone[1]) > 0.1); // else nothing is told apart
  rtwShadowStage stage;
  vtkLight* sun = AddFenceInSun(stage, azimuths[0]);
  stage.Window->SetSize(600, 200);
  stage.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(stage.Pass);
  rtwShadowStage second;
  second.Pass = stage.Pass;
  second.Name = "shared pass";
  vtkLight* other = AddFenceInSun(second, azimuths[1]);
  second.Window->RemoveRenderer(second.Renderer);
  second.Renderer->SetPass(steps);
  second.Renderer->SetViewport(0.5, 0, 1, 1);
  stage.Window->AddRenderer(second.Renderer);
  second.Renderer->ResetCameraClippingRange();
  for (int frame = 0; frame < 4; ++frame)
  {
    stage.Render();
    const glm::dvec3 axis = AxisOf(second); // it is drawn last
    std::cout << "shared pass: the axis is " << glm::distance(axis, alone[0]) << " and "
              << glm::distance(axis, alone[1]) << " from those for one renderer each" << std::endl;
    RTW_CHECK(glm::distance(axis, alone[1]) < 1e-6);
  }
  Check(second, other, 0, 0.3);
  CheckChoice(second, other, 0);
  stage.Window->RemoveRenderer(second.Renderer);
  stage.Renderer->SetViewport(0, 0, 1, 1);
  stage.Render();
  Check(stage, sun, 0, 0.3);
}
}

int TestLightPlaneTurn(int, char*[])
{
  TestSettings();
  TestAligned(rtwTechnique::RTW, rtwChain::Steps);
  TestAligned(rtwTechnique::Uniform, rtwChain::Classic);
  TestAlongTheLight();
  TestAutomatic(rtwTechnique::RTW, rtwChain::Steps);
  TestAutomatic(rtwTechnique::RTW, rtwChain::Classic);
  TestAutomatic(rtwTechnique::Uniform, rtwChain::Steps);
  TestWithOthers();
  TestChanges();
  TestSharedPass();
  return rtwTestResult();
}
