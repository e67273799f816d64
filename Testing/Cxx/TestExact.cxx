// SPDX-License-Identifier: BSD-3-Clause
// Exact hard shadows beside exact rays: any warp, what has no view samples, watertight and closed
// meshes, what outgrows the memory bound, and settings.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkExactShadowMapPass.h"
#include "vtkIdentityShadowMapWarp.h"
#include "vtkImageData.h"
#include "vtkNonOrthogonalShadowMapWarp.h"
#include "vtkProperty.h"
#include "vtkRectilinearShadowMapWarp.h"

#include <algorithm>
#include <iostream>
#include <string>

namespace
{
constexpr rtwShadowBounds Exact{ 0.01, 0.005, 0.1, 0.02, 2.0 };

struct Stage : rtwShadowStage
{
  explicit Stage(const char* name, rtwChain chain = rtwChain::Steps)
    : rtwShadowStage(rtwTechnique::Exact, chain)
  {
    this->Name = name;
    this->Options.Sharp = true;
  }

  vtkExactShadowMapPass* GetPass() { return vtkExactShadowMapPass::SafeDownCast(this->Pass); }
};

// The warp decides how fast it is, not what is seen.
void TestWarps()
{
  Stage stage("warps");
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNew<vtkIdentityShadowMapWarp> identity;
  vtkNew<vtkRectilinearShadowMapWarp> rectilinear;
  vtkNew<vtkNonOrthogonalShadowMapWarp> nonOrthogonal;
  std::vector<unsigned char> first;
  for (vtkShadowMapWarp* warp :
    { static_cast<vtkShadowMapWarp*>(identity), static_cast<vtkShadowMapWarp*>(rectilinear),
      static_cast<vtkShadowMapWarp*>(nonOrthogonal) })
  {
    stage.Pass->SetWarp(warp);
    for (const unsigned int resolution : { 1000u, 64u, 7u })
    {
      stage.Pass->SetResolution(resolution);
      stage.Render();
      const std::vector<unsigned char> mask = stage.GetMask(0);
      first = first.empty() ? mask : first;
      RTW_CHECK(mask == first);
    }
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, Exact);
  }
  // No map was drawn for that.
  RTW_CHECK(stage.Pass->GetShadowMapImage(0) == nullptr);
  RTW_CHECK(stage.Pass->GetNumberOfCastersDrawn(0) > 0);
}

// Translucent receivers look up maps.
void TestMaps()
{
  Stage translucent("translucent");
  translucent.AddObjects();
  vtkLight* light = translucent.AddSun(3, 5, 2);
  vtkActor* pane = translucent.AddBox(-1.5, 0.5, 1.5, 1);
  pane->GetProperty()->SetOpacity(0.5);
  translucent.Render();
  RTW_CHECK_SHADOWS_WITHIN(translucent, light, 0, Exact);
  RTW_CHECK(translucent.Pass->GetShadowMapImage(0) != nullptr);
}

// Each triangle of a closed mesh shadows none of its neighbours where they face the light.
void TestCurved()
{
  for (const int resolution : { 12, 60, 400 })
  {
    Stage stage("curved");
    stage.AddFloor();
    stage.AddBall(0, 1.5, 0, 1.2, resolution);
    vtkLight* sun = stage.AddSun(5, 2, 1);
    vtkLight* spot = stage.AddSpot(-4, 4, 2, 40);
    stage.Render();
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, Exact);
    RTW_CHECK_SHADOWS_WITHIN(stage, spot, 1, Exact);
  }
}

// A lamp between walls that reach behind it.
void TestInside()
{
  Stage stage("inside");
  stage.AddFloor();
  stage.AddBox(0, 3, 0, 8);
  stage.AddBox(1, 0.5, 0, 1);
  stage.AddBall(-1, 1, 0.5, 0.5);
  vtkLight* spot = stage.AddSpot(0, 4, 0.2, 80);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(2.5, 3, 3);
  camera->SetFocalPoint(0, 0, 0);
  stage.Renderer->ResetCameraClippingRange();
  stage.Render();
  rtwShadowBounds rim = Exact;
  rim.Stray = 0.05; // it is long, in a room
  RTW_CHECK_SHADOWS_WITHIN(stage, spot, 0, rim);
}

void TestMemoryBound()
{
  Stage stage("memory bound");
  stage.AddFloor();
  stage.AddBall(0, 1.5, 0, 1.2, 420);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwMessageCatcher messages(stage.Pass);
  stage.GetPass()->SetMemoryBound(0);
  RTW_CHECK_EQUAL(stage.GetPass()->GetMemoryBound(), 16);
  stage.Render();
  rtwShadowBounds maps;
  maps.Wrong = 0.5;
  maps.Far = 0.05;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, maps);
  const std::vector<unsigned char> first = stage.GetMask(0);
  for (int frame = 0; frame < 8; ++frame)
  {
    stage.Render();
  }
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, Exact);
  RTW_CHECK(stage.GetMask(0) != first);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 0); // it has settled
}

// With several samples a pixel the mask is a mean of exact decisions.
void TestPixelSamples()
{
  Stage stage("pixel samples");
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  const std::vector<unsigned char> one = stage.GetMask(0);
  for (const int samples : { 4, 8 })
  {
    stage.GetPass()->SetSamplesPerPixel(samples);
    stage.Render();
    const std::vector<unsigned char> mask = stage.GetMask(0);
    int steps[256] = {}, different = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      ++steps[mask[i]];
      different += (mask[i] < 128) != (one[i] < 128) && mask[i] != 127 && mask[i] != 129;
    }
    const int values = 256 - static_cast<int>(std::count(steps, steps + 256, 0));
    std::cout << samples << " samples: " << values << " values, " << different
              << " pixels on another side" << std::endl;
    RTW_CHECK_EQUAL(values, samples + 2); // 128 is one of them
    RTW_CHECK(different < static_cast<int>(mask.size() / 100));
    rtwShadowBounds edges;
    edges.Wrong = 0.8; // centre and mean may differ
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, edges);
  }
  stage.GetPass()->SetSamplesPerPixel(1);
  stage.Render();
  RTW_CHECK(stage.GetMask(0) == one);
}

void TestSettings()
{
  Stage stage("settings");
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwMessageCatcher messages(stage.Pass);
  stage.GetPass()->SetSamplesPerPixel(3);
  RTW_CHECK_EQUAL(stage.GetPass()->GetSamplesPerPixel(), 1);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 1);
  stage.GetPass()->SetMemoryBound(1000000);
  RTW_CHECK_EQUAL(stage.GetPass()->GetMemoryBound(), 98304);
  RTW_CHECK_EQUAL(stage.GetPass()->GetLongestList(0), 0);
  stage.GetPass()->CountListsOn();
  stage.Render();
  RTW_CHECK(stage.GetPass()->GetNumberOfListedSamples(0) > 5000);
  RTW_CHECK(stage.GetPass()->GetLongestList(0) >= stage.GetPass()->GetListPercentile99(0));
  RTW_CHECK(stage.GetPass()->GetListPercentile99(0) > 0);
  RTW_CHECK_EQUAL(stage.GetPass()->GetLongestList(1), 0);
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, Exact);
  // What stands still is drawn once.
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 0);
  sun->SetPosition(-3, 5, 1);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, Exact);
}

// It shows, of several lights, that which is asked for; passes that have no lists warn once.
void TestDebugView()
{
  Stage stage("lists");
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  vtkLight* low = stage.AddSun(-5, 2, 1);
  stage.Render();
  const vtkSmartPointer<vtkImageData> lit = rtwGrab(stage.Window);
  vtkSmartPointer<vtkImageData> views[2];
  stage.Pass->SetDebugViewToListLengths();
  stage.Pass->SetResolution(40); // enough samples to differ
  for (int light = 0; light < 2; ++light)
  {
    stage.Pass->SetDebugLight(light);
    stage.Render();
    views[light] = rtwGrab(stage.Window);
  }
  int sameAsLit = 0, same = 0, pixels = 0;
  for (int y = 0; y < views[0]->GetDimensions()[1]; y += 3)
  {
    for (int x = 0; x < views[0]->GetDimensions()[0]; x += 3)
    {
      ++pixels;
      sameAsLit += rtwPixel(lit, x, y) == rtwPixel(views[0], x, y);
      same += rtwPixel(views[1], x, y) == rtwPixel(views[0], x, y);
    }
  }
  RTW_CHECK(sameAsLit < pixels / 2);
  RTW_CHECK(same < pixels * 19 / 20);
  RTW_CHECK_SHADOWS_WITHIN(stage, low, 1, Exact);

  rtwShadowStage maps(rtwTechnique::RTW);
  maps.AddObjects();
  maps.AddSun(3, 5, 2);
  rtwMessageCatcher messages(maps.Pass);
  maps.Pass->SetDebugViewToListLengths();
  maps.Render();
  maps.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
}
}

int TestExact(int, char*[])
{
  TestWarps();
  TestMaps();
  TestCurved();
  TestInside();
  TestMemoryBound();
  TestPixelSamples();
  TestSettings();
  TestDebugView();
  return rtwTestResult();
}
