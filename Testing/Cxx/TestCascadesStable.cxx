// SPDX-License-Identifier: BSD-3-Clause
// Layers that stay in place: texels lie still in the world while the camera moves and turns, so
// that the shadow of each point stays what it is.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkCascadedShadowMapPass.h"
#include "vtkMatrix4x4.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{
constexpr int Layers = 3;
constexpr int Resolution = 256;

// Where a point lies on a layer's map, in texels.
glm::dvec2 TexelOf(rtwShadowStage& stage, int layer, const glm::dvec3& point)
{
  vtkNew<vtkMatrix4x4> matrix;
  RTW_CHECK(stage.Pass->GetLightPlaneMatrix(0, layer, matrix));
  const double in[] = { point.x, point.y, point.z, 1 };
  double out[4];
  matrix->MultiplyPoint(in, out);
  return glm::dvec2(out[0], out[1]) * (double(Resolution) / out[3]);
}

void SetUp(rtwShadowStage& stage, bool stable)
{
  stage.AddFloor(60);
  for (int i = 0; i < 9; ++i)
  {
    stage.AddBox(6.0 * (i % 3) - 6.0, 1.0, -7.0 * (i / 3), 1.7);
  }
  auto* pass = vtkCascadedShadowMapPass::SafeDownCast(stage.Pass);
  pass->SetNumberOfLayers(Layers);
  pass->SetStable(stable);
  pass->SetResolution(Resolution);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0, 5, 14);
  camera->SetFocalPoint(0, 1, 0);
}

// How far, at most, a map's texels stray from where they were, whichever layer; and whether its
// size changes.
double MostStray(rtwShadowStage& stage, void move(vtkCamera*, int), double* stretch)
{
  const glm::dvec3 a(1, 0, 2), b(3, 1, -4);
  double most = 0;
  std::vector<glm::dvec2> places, sizes;
  for (int frame = 0; frame < 12; ++frame)
  {
    move(stage.Renderer->GetActiveCamera(), frame);
    stage.Renderer->ResetCameraClippingRange();
    stage.Render();
    for (int layer = 0; layer < Layers; ++layer)
    {
      const glm::dvec2 place = TexelOf(stage, layer, a);
      const glm::dvec2 size = TexelOf(stage, layer, b) - place;
      if (frame == 0)
      {
        places.push_back(place);
        sizes.push_back(size);
        continue;
      }
      const glm::dvec2 moved = place - places[layer];
      most = std::max(
        { most, std::abs(moved.x - std::round(moved.x)), std::abs(moved.y - std::round(moved.y)) });
      *stretch = std::max(*stretch, glm::length(size - sizes[layer]));
    }
  }
  return most;
}

void Pan(vtkCamera* camera, int frame)
{
  camera->SetPosition(0.37 * frame, 5 + 0.11 * frame, 14 - 0.23 * frame);
  camera->SetFocalPoint(0.37 * frame, 1 + 0.11 * frame, -0.23 * frame);
}

void Turn(vtkCamera* camera, int frame)
{
  const double angle = 0.07 * frame;
  camera->SetPosition(0, 5, 14);
  camera->SetFocalPoint(14 * std::sin(angle), 5 - 4 * std::cos(angle), 14 - 14 * std::cos(angle));
}

void TestTexels()
{
  for (const bool stable : { true, false })
  {
    for (auto* move : { Pan, Turn })
    {
      rtwShadowStage stage(rtwTechnique::Cascades);
      SetUp(stage, stable);
      stage.AddSun(3, 5, 2);
      double stretch = 0;
      const double stray = MostStray(stage, move, &stretch);
      std::cout << (stable ? "stable, " : "fitted, ") << (move == Pan ? "moved" : "turned")
                << ": texels stray by " << stray << ", and by " << stretch << " between two points"
                << std::endl;
      RTW_CHECK_EQUAL(stray < 0.01 && stretch < 0.01, stable);
    }
  }
}

// A parallel view that moves by whole pixels sees the same points one pixel on.
int FlickeringPixels(rtwShadowStage& stage)
{
  constexpr double pixel = 0.05;
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const int* size = stage.Window->GetSize();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * pixel * size[1]);
  camera->SetClippingRange(1, 40);
  double forward[3];
  camera->GetDirectionOfProjection(forward);
  int flickering = 0;
  std::vector<unsigned char> last;
  for (int frame = 0; frame < 16; ++frame)
  {
    camera->SetPosition(pixel * frame, 5, 14);
    camera->SetFocalPoint(pixel * frame, 1, 0);
    stage.Render();
    const std::vector<unsigned char> mask = stage.GetMask(0);
    for (int y = 0; frame > 0 && y < size[1]; ++y)
    {
      for (int x = 0; x + 1 < size[0]; ++x)
      {
        const int now = mask[std::size_t(y) * size[0] + x];
        const int before = last[std::size_t(y) * size[0] + x + 1];
        // The view's own edges of objects may fall between other pixels by rounding.
        flickering += (now < 128) != (before < 128) && now != 128 && before != 128;
      }
    }
    last = mask;
  }
  return flickering;
}

void TestFlicker()
{
  int pixels[2];
  for (const bool stable : { true, false })
  {
    rtwShadowStage stage(rtwTechnique::Cascades);
    SetUp(stage, stable);
    stage.AddSun(3, 5, 2);
    pixels[stable] = FlickeringPixels(stage);
    std::cout << (stable ? "stable: " : "fitted: ") << pixels[stable]
              << " decisions of the same point differ from frame to frame" << std::endl;
  }
  RTW_CHECK_EQUAL(pixels[1], 0);
  RTW_CHECK(pixels[0] > 100);
}

// They are right, too, and hold all that is seen, whatever light it is.
void TestShadows()
{
  rtwShadowStage stage(rtwTechnique::Cascades);
  stage.Name = "stable";
  auto* pass = vtkCascadedShadowMapPass::SafeDownCast(stage.Pass);
  pass->StableOn();
  pass->SetResolution(2048);
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkLight* spot = stage.AddSpot(3, 7, 2, 40);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.3; // layers hold much that isn't there
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_SHADOWS_WITHIN(stage, spot, 1, bounds);
  stage.Name = "stable, filtered, blended";
  pass->SetBlendWidth(0.3);
  pass->SetFilterToPCF();
  pass->SetFilterRadius(3);
  stage.Render();
  bounds.Wrong = 0.6;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "not focused";
  pass->StableOff();
  pass->SetFilterToBilinear();
  pass->FocusOnViewOff();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 8);
}
}

int TestCascadesStable(int, char*[])
{
  TestTexels();
  TestFlicker();
  TestShadows();
  return rtwTestResult();
}
