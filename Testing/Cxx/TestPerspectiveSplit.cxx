// SPDX-License-Identifier: BSD-3-Clause
// Perspective maps that aren't square: as many texels in all, less error where there is much to
// gain, filters at the rim, and maps that last while cameras move.
#include "rtwDeepStage.h"
#include "rtwEachTechnique.h"
#include "rtwSceneStage.h"

#include "vtkCamera.h"
#include "vtkCascadedShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPerspectiveShadowMapPass.h"
#include "vtkPerspectiveShadowMapWarp.h"
#include "vtkShadowRenderStepsPass.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace
{
vtkPerspectiveShadowMapPass* PassOf(rtwShadowStage& stage)
{
  return vtkPerspectiveShadowMapPass::SafeDownCast(stage.Pass);
}

glm::ivec2 SizeOf(vtkAdaptiveShadowMapPass* pass, int light = 0, int layer = 0)
{
  vtkImageData* map = pass->GetShadowMapImage(light, layer);
  return map ? glm::ivec2(map->GetDimensions()[0], map->GetDimensions()[1]) : glm::ivec2(0);
}

// Of a frame that is drawn: no more texels than the square has, and nearly all of them.
glm::ivec2 CheckedSize(vtkAdaptiveShadowMapPass* pass)
{
  const glm::ivec2 size = SizeOf(pass);
  const double texels = std::pow(pass->GetResolution(), 2);
  RTW_CHECK(double(size.x) * size.y <= texels);
  RTW_CHECK(double(size.x) * size.y > 0.98 * texels);
  return size;
}

double RatioOf(const glm::ivec2& size)
{
  return double(size.x) / size.y;
}

struct Deep : rtwDeepStage
{
  Deep()
    : rtwDeepStage(rtwTechnique::Perspective, 20)
  {
  }

  double Measure(const std::string& name)
  {
    const rtw::ShadowErrors errors = this->Compare(name.c_str());
    RTW_CHECK(errors.Percent(errors.FarFromEdge) < 0.02);
    return errors.Percent(errors.Wrong());
  }
};

// In the ratio that is asked for; memory is that of the square, but for what rounding leaves out.
void TestRatios()
{
  Deep stage;
  vtkPerspectiveShadowMapPass* pass = PassOf(stage);
  pass->SetResolutionSplitToSquare();
  const double square = stage.Measure("square");
  RTW_CHECK_EQUAL(SizeOf(pass).x, 512);
  RTW_CHECK_EQUAL(SizeOf(pass).y, 512);
  const auto memory = pass->GetShadowMemory();
  const double even[] = { pass->GetMaximumEffectiveResolution(0, 0),
    pass->GetMaximumEffectiveResolution(0, 1) };
  for (const double ratio : { 0.25, 0.6, 1.0, 1.7, 4.0 })
  {
    pass->SetResolutionRatio(ratio);
    const double wrong = stage.Measure("ratio " + std::to_string(ratio));
    const glm::ivec2 size = CheckedSize(pass);
    RTW_CHECK_NEAR(double(size.x) / size.y, ratio, 0.01 * ratio);
    RTW_CHECK(pass->GetShadowMemory() <= memory);
    // A texel is 4 bytes of depth and 4 of gradients.
    RTW_CHECK_EQUAL(memory - pass->GetShadowMemory(), 8 * (512 * 512 - size.x * size.y));
    for (int axis = 0; axis < 2; ++axis)
    {
      RTW_CHECK_NEAR(
        pass->GetMaximumEffectiveResolution(0, axis) / even[axis], size[axis] / 512.0, 1e-3);
    }
    RTW_CHECK(wrong < 2.5 * square);
  }
  pass->SetResolutionSplitToSquare();
  RTW_CHECK_NEAR(stage.Measure("square again"), square, 1e-9);
}

// What a split is worth, and the ratio that Equations 13 and 14 have. Texels are as many.
void TestWorth()
{
  rtwSceneStage stage("playground");
  vtkNew<vtkPerspectiveShadowMapPass> pass;
  pass->SetResolution(512);
  pass->SetResolutionSplitToSquare();
  const auto measure = [&](const char* name) {
    const rtw::ShadowErrors errors = stage.Measure(pass);
    std::cout << stage.Name << ", " << name << ": " << errors.Percent(errors.Wrong()) << " % wrong"
              << std::endl;
    return errors.Percent(errors.Wrong());
  };
  const double square = measure("square");
  pass->SetResolutionSplitToCritical();
  RTW_CHECK(measure("critical") < 0.95 * square);
  pass->SetResolutionRatio(0.42);
  RTW_CHECK(measure("ratio 0.42") < 0.9 * square);
  pass->SetResolutionSplitToAutomatic();
  RTW_CHECK(measure("automatic") < 0.92 * square);
}

// The light overhead and the frustum within the scene, so that Equations 9 to 14 hold as they are:
// the ratio is 2 f tan θ / (f - n) for LiSPSM.
void TestCritical()
{
  for (const double angle : { 30.0, 60.0, 90.0 })
  {
    rtwShadowStage stage(rtwTechnique::Perspective);
    for (const double y : { -150, 150 })
    {
      stage.AddBox(0, y, 0, 100);
    }
    stage.AddFloor(400);
    stage.Window->SetSize(300, 300);
    stage.AddSun(0, 1, 0);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetPosition(0, 3, 100);
    camera->SetFocalPoint(0, 3, 0);
    camera->SetViewAngle(angle);
    camera->SetClippingRange(1, 100);
    PassOf(stage)->SetResolutionSplitToCritical();
    stage.Render();
    const double expected = 2 * std::tan(vtkMath::RadiansFromDegrees(angle) / 2) * 100 / 99;
    const double ratio = RatioOf(CheckedSize(stage.Pass));
    std::cout << "view angle " << angle << ": ratio " << ratio << ", critical " << expected
              << std::endl;
    RTW_CHECK(std::abs(std::log2(ratio / expected)) < 0.5 / 4 + 0.01);
  }
}

// Each filter, on maps so narrow that much of what is seen lies at a rim, beside exact rays and
// beside the same picture of a square map.
void TestFilters()
{
  rtwShadowStage stage(rtwTechnique::Perspective);
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkPerspectiveShadowMapPass* pass = PassOf(stage);
  for (const int filter : { vtkAdaptiveShadowMapPass::NEAREST, vtkAdaptiveShadowMapPass::BILINEAR,
         vtkAdaptiveShadowMapPass::PCF, vtkAdaptiveShadowMapPass::SOFT })
  {
    pass->SetFilter(filter);
    pass->SetFilterRadius(filter == vtkAdaptiveShadowMapPass::SOFT ? 0.01 : 1);
    for (const double ratio : { 1.0, 1.0 / 16, 16.0 })
    {
      pass->SetResolutionRatio(ratio);
      stage.Name = "filter " + std::to_string(filter) + ", ratio " + std::to_string(ratio);
      stage.Render();
      RTW_CHECK_SHADOWS(stage, sun, 0);
    }
  }
}

// A floor from above, all lit, whose picture ends where the map does: nothing beyond that is read.
void TestRim()
{
  rtwShadowStage stage(rtwTechnique::Perspective);
  stage.AddFloor(100);
  stage.AddSun(0, 1, 0);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(4);
  camera->SetPosition(0, 10, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, -1);
  stage.Renderer->ResetCameraClippingRange();
  vtkPerspectiveShadowMapPass* pass = PassOf(stage);
  pass->SetResolution(64);
  for (const int filter : { vtkAdaptiveShadowMapPass::NEAREST, vtkAdaptiveShadowMapPass::BILINEAR,
         vtkAdaptiveShadowMapPass::PCF, vtkAdaptiveShadowMapPass::SOFT })
  {
    pass->SetFilter(filter);
    pass->SetFilterRadius(filter == vtkAdaptiveShadowMapPass::SOFT ? 0.5 : 2);
    for (const double ratio : { 1.0, 1.0 / 16, 16.0 })
    {
      pass->SetResolutionRatio(ratio);
      stage.Render();
      const std::vector<unsigned char> mask = stage.GetMask(0);
      const auto lit = std::count(mask.begin(), mask.end(), 255);
      std::cout << "rim, filter " << filter << ", ratio " << ratio << ": " << lit << " of "
                << mask.size() << " pixels lit" << std::endl;
      RTW_CHECK(lit == std::ptrdiff_t(mask.size()));
    }
  }
}

void TestLightsAndMappers()
{
  rtwShadowStage lights(rtwTechnique::Perspective);
  lights.Name = "lights";
  PassOf(lights)->SetResolutionSplitToCritical();
  rtwCheckLights(lights);
  RTW_CHECK(SizeOf(lights.Pass, 0) == SizeOf(lights.Pass, 2));
  CheckedSize(lights.Pass);
  // Without a mask there is no prediction.
  rtwShadowStage many(rtwTechnique::Perspective);
  many.Name = "view samples of the frame before";
  many.AddObjects();
  vtkLight* sun = many.AddSun(3, 5, 2);
  many.Pass->SetViewSampleSourceToPreviousFrame();
  for (int i = 0; i < 3; ++i)
  {
    many.Renderer->GetActiveCamera()->Azimuth(0.1);
    many.Render();
    RTW_CHECK_SHADOWS(many, sun, 0);
    CheckedSize(many.Pass);
  }
  for (const double ratio : { 0.5, 2.0 })
  {
    rtwShadowStage glyphs(rtwTechnique::Perspective);
    glyphs.Name = "glyphs";
    PassOf(glyphs)->SetResolutionRatio(ratio);
    rtwCheckGlyphs(glyphs);
  }
}

// A camera that walks and turns: a map has few sizes on its way, each for long.
void TestSweep(int split)
{
  Deep stage;
  vtkPerspectiveShadowMapPass* pass = PassOf(stage);
  pass->SetResolutionSplit(split);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  glm::ivec2 last(0);
  int changes = -1;
  std::ptrdiff_t darkest = 0, least = 1 << 30;
  for (int i = 0; i < 120; ++i)
  {
    camera->Azimuth(0.5);
    camera->Elevation(i < 60 ? 0.2 : -0.2);
    camera->Dolly(i % 2 ? 1.01 : 0.992);
    stage.Renderer->ResetCameraClippingRange();
    stage.Render();
    const glm::ivec2 size = CheckedSize(pass);
    changes += size != last;
    last = size;
    const std::vector<unsigned char> mask = stage.GetMask(0);
    RTW_CHECK(std::count(mask.begin(), mask.end(), 255) > 1000);
    least = std::min(least, std::count(mask.begin(), mask.end(), 0));
    darkest = std::max(darkest, std::count(mask.begin(), mask.end(), 0));
  }
  std::cout << "sweep: " << changes << " changes in 120 frames, dark " << least << " to " << darkest
            << std::endl;
  RTW_CHECK(changes <= 6);
}

// Sizes of window and map, another viewer, and back.
void TestChanges(int split)
{
  Deep stage;
  vtkPerspectiveShadowMapPass* pass = PassOf(stage);
  pass->SetResolutionSplit(split);
  stage.Render();
  const glm::ivec2 first = CheckedSize(pass);
  stage.Render();
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersReused(), 1);
  pass->SetResolution(100);
  stage.Render();
  CheckedSize(pass);
  pass->SetResolution(1);
  stage.Render();
  RTW_CHECK(SizeOf(pass) == glm::ivec2(1));
  pass->SetResolution(512);
  const glm::ivec2 window(stage.Window->GetSize()[0], stage.Window->GetSize()[1]);
  stage.Window->SetSize(500, 200);
  stage.Render();
  CheckedSize(pass);
  stage.Name = "wide window";
  RTW_CHECK_SHADOWS_WITHIN(stage, stage.Sun, 0, (rtwShadowBounds{ 0.15, 0.01, 0.1, 0.02, 0.2 }));
  stage.Window->SetSize(window.x, window.y);
  stage.Render();
  // No farther off than by the step that it holds.
  RTW_CHECK_NEAR(RatioOf(CheckedSize(pass)) / RatioOf(first), 1, 0.2);
  // Two renderers with one pass.
  vtkNew<vtkRenderer> other;
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(pass);
  other->SetPass(steps);
  other->AddActor(stage.AddBall(0, 1, 0, 1));
  other->AddLight(stage.Sun);
  other->SetViewport(0.5, 0, 1, 1);
  other->GetActiveCamera()->SetPosition(0, 20, 0.1);
  other->ResetCameraClippingRange();
  stage.Renderer->SetViewport(0, 0, 0.5, 1);
  stage.Window->AddRenderer(other);
  glm::ivec2 both(0);
  for (int i = 0; i < 8; ++i)
  {
    stage.Renderer->GetActiveCamera()->Azimuth(0.1);
    other->GetActiveCamera()->Azimuth(0.1);
    stage.Render();
    // The first frames know of one only.
    both = i < 2 ? CheckedSize(pass) : both;
    RTW_CHECK(CheckedSize(pass) == both);
  }
  stage.Window->RemoveRenderer(other);
}

// Layers have one size; those that keep still are square.
void TestCascades()
{
  Deep stage;
  vtkNew<vtkCascadedShadowMapPass> cascades;
  vtkNew<vtkPerspectiveShadowMapWarp> warp;
  warp->SetResolutionRatio(0.5);
  cascades->SetWarp(warp);
  cascades->SetResolution(256);
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(cascades);
  stage.Renderer->SetPass(steps);
  const auto measure = [&](const char* name) {
    stage.Window->Render();
    const rtw::ShadowErrors errors =
      rtw::Compare(rtw::MaskOf(cascades->GetShadowMask(0)), stage.Truth);
    std::cout << name << ": " << errors.Percent(errors.Wrong()) << " % wrong" << std::endl;
    RTW_CHECK(errors.Percent(errors.FarFromEdge) < 0.02);
    return errors.Percent(errors.Wrong());
  };
  const double split = measure("4 layers, ratio 0.5");
  for (int layer = 0; layer < 4; ++layer)
  {
    RTW_CHECK(SizeOf(cascades, 0, layer) == SizeOf(cascades));
  }
  RTW_CHECK_NEAR(double(CheckedSize(cascades).x) / SizeOf(cascades).y, 0.5, 0.01);
  warp->SetResolutionSplitToSquare();
  const double square = measure("4 layers, square");
  RTW_CHECK_NEAR(split, square, square);
  warp->SetResolutionSplitToCritical();
  measure("4 layers, critical");
  CheckedSize(cascades);
  warp->SetResolutionSplitToAutomatic();
  measure("4 layers, automatic");
  CheckedSize(cascades);
  cascades->StableOn();
  measure("4 layers that keep still");
  RTW_CHECK(SizeOf(cascades) == glm::ivec2(256));
  cascades->ReleaseGraphicsResources(stage.Window);
  stage.UsePass(true);
}

void TestBadInput()
{
  vtkNew<vtkPerspectiveShadowMapPass> pass;
  vtkPerspectiveShadowMapWarp* warp = pass->GetPerspectiveWarp();
  rtwMessageCatcher messages(warp);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), 0.0, -1.0, 0.06, 16.1,
         std::numeric_limits<double>::infinity() })
  {
    pass->SetResolutionRatio(bad);
  }
  pass->SetResolutionSplit(-1);
  pass->SetResolutionSplit(4);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 8);
  RTW_CHECK_EQUAL(pass->GetResolutionRatio(), 1.0);
  RTW_CHECK_EQUAL(pass->GetResolutionSplit(), vtkPerspectiveShadowMapPass::SPLIT_AUTOMATIC);
  pass->SetResolutionRatio(2);
  RTW_CHECK_EQUAL(warp->GetResolutionSplit(), vtkPerspectiveShadowMapWarp::SPLIT_BY_RATIO);
}
}

int TestPerspectiveSplit(int, char*[])
{
  TestRatios();
  TestWorth();
  TestCritical();
  TestFilters();
  TestRim();
  TestLightsAndMappers();
  for (const int split :
    { vtkPerspectiveShadowMapPass::SPLIT_CRITICAL, vtkPerspectiveShadowMapPass::SPLIT_AUTOMATIC })
  {
    TestSweep(split);
    TestChanges(split);
  }
  TestCascades();
  TestBadInput();
  return rtwTestResult();
}
