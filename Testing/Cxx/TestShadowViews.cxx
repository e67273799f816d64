// SPDX-License-Identifier: BSD-3-Clause
// Windows, viewports and cameras of all shapes.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkCascadedShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkShadowRenderStepsPass.h"

#include <algorithm>

namespace
{
void TestShapes()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkLight* spot = stage.AddSpot(-3, 7, 2, 40);
  sun->SetIntensity(0.5);
  spot->SetIntensity(0.4);
  const int sizes[][2] = { { 400, 150 }, { 150, 400 }, { 301, 199 }, { 60, 40 } };
  for (const auto& size : sizes)
  {
    stage.Name = std::to_string(size[0]) + " by " + std::to_string(size[1]);
    stage.Window->SetSize(size[0], size[1]);
    stage.Render();
    rtwShadowBounds bounds;
    if (size[0] < 100)
    {
      bounds = { 0.6, 0.1, 0.3, 0.3, 1 }; // a pixel is a larger share
    }
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
    RTW_CHECK_SHADOWS_WITHIN(stage, spot, 1, bounds);
    if (size[0] >= 100)
    {
      RTW_CHECK_PICTURE(stage);
    }
  }
}

void TestParallel()
{
  for (const bool spot : { false, true })
  {
    rtwShadowStage stage;
    stage.Name = spot ? "parallel, spot" : "parallel, sun";
    stage.AddObjects();
    vtkLight* light = spot ? stage.AddSpot(3, 7, 2, 40) : stage.AddSun(3, 5, 2);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(3.5);
    stage.Render();
    RTW_CHECK_SHADOWS(stage, light, 0);
    RTW_CHECK_PICTURE(stage);
    stage.Name += ", then perspective";
    camera->ParallelProjectionOff();
    stage.Render();
    RTW_CHECK_SHADOWS(stage, light, 0);
  }
}

void TestCameras()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const auto check = [&](const char* name) {
    stage.Name = name;
    stage.Render();
    rtwShadowBounds bounds;
    bounds.Shadowed = 0.5;
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
    RTW_CHECK_PICTURE(stage);
  };
  camera->SetWindowCenter(0.4, -0.3);
  check("off-centre");
  camera->SetWindowCenter(0, 0);
  camera->Roll(70);
  check("rolled");
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(100);
  check("wide angle");
  camera->SetViewAngle(30);
  camera->SetPosition(-2.5, 0.3, 0.5); // in the shadow of the ball
  camera->SetFocalPoint(2, 0.3, -0.5);
  check("close to the ground");
  camera->SetPosition(0, 12, 0.01);
  camera->SetFocalPoint(0, 0, 0);
  check("from above");
}

// Inside a ball that the sun does not reach: all is in shadow.
void TestInside()
{
  rtwShadowStage stage;
  stage.Name = "inside";
  stage.AddFloor();
  stage.AddBall(0, 1, 0, 3, 24);
  stage.AddBox(0, 0.6, 0, 1);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0.5, 1.5, 2.2);
  camera->SetFocalPoint(0, 0.5, 0);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

// Two renderers side by side, each with a pass of its own, the second also offset in height.
void TestViewports(rtwTechnique ofLeft, rtwTechnique ofRight)
{
  rtwShadowStage left(ofLeft);
  left.Name = "left viewport";
  left.AddObjects();
  vtkLight* sun = left.AddSun(3, 5, 2);
  left.Renderer->SetViewport(0, 0, 0.4, 1);
  rtwShadowStage right(ofRight);
  right.Name = "right viewport";
  right.AddObjects();
  vtkLight* spot = right.AddSpot(3, 7, 2, 40);
  right.Window->RemoveRenderer(right.Renderer);
  right.Renderer->SetViewport(0.45, 0.2, 1, 0.9);
  left.Window->AddRenderer(right.Renderer);
  right.Renderer->ResetCameraClippingRange();
  for (int frame = 0; frame < 2; ++frame)
  {
    left.Render();
    RTW_CHECK_SHADOWS(left, sun, 0);
    RTW_CHECK_SHADOWS(right, spot, 0);
    left.Renderer->GetActiveCamera()->Azimuth(10);
  }
  // The picture in the viewport is that of a window of its size.
  const vtkSmartPointer<vtkImageData> both = rtwGrab(left.Window);
  const int* origin = right.Renderer->GetOrigin();
  const int x0 = origin[0], y0 = origin[1];
  const int width = right.Renderer->GetSize()[0], height = right.Renderer->GetSize()[1];
  left.Window->RemoveRenderer(right.Renderer);
  right.Window->AddRenderer(right.Renderer);
  right.Renderer->SetViewport(0, 0, 1, 1);
  right.Window->SetSize(width, height);
  right.Render();
  RTW_CHECK_PICTURE(right);
  right.Render();
  const vtkSmartPointer<vtkImageData> alone = rtwGrab(right.Window);
  int differ = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const auto a = rtwPixel(both, x0 + x, y0 + y), b = rtwPixel(alone, x, y);
      differ += std::abs(a[0] - b[0]) > 6;
    }
  }
  std::cout << "viewport and window differ at " << differ << " pixels" << std::endl;
  RTW_CHECK(differ < width * height / 200);
}

// One pass for two renderers: each frame is drawn anew, and each is right.
void TestSharedPass(rtwTechnique technique, bool stable)
{
  rtwShadowStage stage(technique);
  if (auto* cascades = vtkCascadedShadowMapPass::SafeDownCast(stage.Pass))
  {
    cascades->SetStable(stable);
  }
  stage.Name = "shared pass, first";
  stage.AddObjects();
  vtkLight* one = stage.AddSun(3, 5, 2);
  stage.Window->SetSize(400, 150);
  stage.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(stage.Pass);
  rtwShadowStage second;
  second.Pass = stage.Pass;
  second.Name = "shared pass";
  second.AddObjects();
  vtkLight* other = second.AddSun(-3, 5, 2);
  second.Window->RemoveRenderer(second.Renderer);
  second.Renderer->SetPass(steps);
  second.Renderer->SetViewport(0.5, 0, 1, 1);
  stage.Window->AddRenderer(second.Renderer);
  second.Renderer->ResetCameraClippingRange();
  second.Renderer->GetActiveCamera()->Azimuth(25);
  stage.Render();
  stage.Render();
  rtwShadowBounds bounds;
  bounds.Wrong = stable ? 0.3 : bounds.Wrong; // layers hold much that isn't there
  RTW_CHECK_SHADOWS_WITHIN(second, other, 0, bounds);
  stage.Window->RemoveRenderer(second.Renderer);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, one, 0, bounds);
}

// Samples within a pixel see other surfaces than its centre, so that the picture looks shadows up
// by itself.
void TestMultiSamples()
{
  rtwShadowStage stage;
  stage.Name = "multisampled";
  stage.Window->SetMultiSamples(4);
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  std::cout << "samples: " << stage.Window->GetMultiSamples() << std::endl;
  RTW_CHECK_SHADOWS(stage, sun, 0);
  stage.Render();
  RTW_CHECK_PICTURE(stage);
  stage.Name = "off-screen";
  stage.Window->SetMultiSamples(0);
  stage.Window->SetOffScreenRendering(1);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowViews(int, char*[])
{
  TestShapes();
  TestParallel();
  TestCameras();
  TestInside();
  TestViewports(rtwTechnique::RTW, rtwTechnique::Uniform);
  TestViewports(rtwTechnique::Cascades, rtwTechnique::Cascades);
  TestSharedPass(rtwTechnique::RTW, false);
  TestSharedPass(rtwTechnique::Cascades, false);
  TestSharedPass(rtwTechnique::Cascades, true);
  TestMultiSamples();
  return rtwTestResult();
}
