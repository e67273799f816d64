// SPDX-License-Identifier: BSD-3-Clause
// Layers that stay in place: texels lie still in the world while the camera moves and turns, so
// that the shadow of each point stays what it is.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkCascadedShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <utility>
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

// What a layer knows of the world in a frame.
struct Layer
{
  vtkNew<vtkMatrix4x4> ToMap; ///< depth goes along
  std::vector<float> Depths;
  double From, To; ///< along the view

  glm::dvec3 Place(const glm::dvec3& point) const
  {
    const double in[] = { point.x, point.y, point.z, 1 };
    double out[4];
    this->ToMap->MultiplyPoint(in, out);
    return glm::dvec3(out[0] * Resolution, out[1] * Resolution, out[2]) / out[3];
  }

  /// Of the texel that a point lies in: 1 lit, 0 in shadow, -1 beside the map.
  int Decide(const glm::dvec3& point) const
  {
    const glm::dvec3 at = this->Place(point);
    const glm::ivec2 texel = glm::floor(glm::dvec2(at));
    const bool isHeld =
      texel.x >= 0 && texel.y >= 0 && texel.x < Resolution && texel.y < Resolution;
    return isHeld ? this->Depths[texel.y * Resolution + texel.x] >= at.z - 1e-3 : -1;
  }
};

using Layers3 = std::array<Layer, Layers>;

std::unique_ptr<Layers3> ReadLayers(rtwShadowStage& stage)
{
  auto layers = std::make_unique<Layers3>();
  for (int i = 0; i < Layers; ++i)
  {
    Layer& layer = (*layers)[i];
    double range[2] = { 0, 0 };
    RTW_CHECK(stage.Pass->GetLightPlaneMatrix(0, i, layer.ToMap));
    RTW_CHECK(stage.Pass->GetLayerDepthRange(0, i, range));
    layer.From = range[0];
    layer.To = range[1];
    vtkImageData* map = stage.Pass->GetShadowMapImage(0, i);
    for (int k = 0; map && k < Resolution * Resolution; ++k)
    {
      layer.Depths.push_back(map->GetScalarComponentAsFloat(k % Resolution, k / Resolution, 0, 0));
    }
    RTW_CHECK_EQUAL(int(layer.Depths.size()), Resolution * Resolution);
  }
  return layers;
}

// Texels of the same place in the world whose depth is another one.
int ChangedTexels(const Layer& before, const Layer& now)
{
  const glm::dvec2 shift = now.Place(glm::dvec3(0)) - before.Place(glm::dvec3(0));
  const glm::ivec2 moved = glm::round(shift);
  int changed = 0;
  for (int t = 0; t < Resolution; ++t)
  {
    for (int s = 0; s < Resolution; ++s)
    {
      const glm::ivec2 to = glm::ivec2(s, t) + moved;
      const bool isHeld = to.x >= 0 && to.y >= 0 && to.x < Resolution && to.y < Resolution;
      changed += isHeld &&
        std::abs(now.Depths[to.y * Resolution + to.x] - before.Depths[t * Resolution + s]) > 1e-5;
    }
  }
  return changed;
}

// Of points of the floor, decisions that change while the same layer holds them.
int ChangedDecisions(const Layer& before, const Layer& now, int* compared)
{
  int changed = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const double a = std::fmod(0.7548776662 * i, 1.0), b = std::fmod(0.5698402910 * i, 1.0);
    const glm::dvec3 point(24 * a - 12, 0, 24 * b - 18);
    const int was = before.Decide(point), is = now.Decide(point);
    *compared += was >= 0 && is >= 0;
    changed += was >= 0 && is >= 0 && was != is;
  }
  return changed;
}

// A camera that goes by no number of whole pixels, and neither of texels, nor along an axis.
void TestTranslation()
{
  for (const bool stable : { true, false })
  {
    rtwShadowStage stage(rtwTechnique::Cascades);
    SetUp(stage, stable);
    stage.AddSun(3, 5, 2);
    // Nothing but the camera makes a difference.
    stage.Renderer->GetActiveCamera()->SetClippingRange(0.5, 80);
    int texels = 0, decisions = 0, compared = 0;
    std::unique_ptr<Layers3> before;
    for (int frame = 0; frame < 10; ++frame)
    {
      const glm::dvec3 moved = 0.173 * frame * glm::dvec3(1, 0.31, -0.77);
      vtkCamera* camera = stage.Renderer->GetActiveCamera();
      camera->SetPosition(moved.x, 5 + moved.y, 14 + moved.z);
      camera->SetFocalPoint(moved.x, 1 + moved.y, moved.z);
      stage.Render();
      std::unique_ptr<Layers3> now = ReadLayers(stage);
      for (int i = 0; before && i < Layers; ++i)
      {
        RTW_CHECK(!stable || (*now)[i].From == (*before)[i].From);
        texels += ChangedTexels((*before)[i], (*now)[i]);
        decisions += ChangedDecisions((*before)[i], (*now)[i], &compared);
      }
      before = std::move(now);
    }
    std::cout << (stable ? "stable" : "fitted") << ", by parts of pixels: " << texels
              << " texels and " << decisions << " of " << compared << " decisions differ"
              << std::endl;
    RTW_CHECK(compared > 10000);
    RTW_CHECK_EQUAL(texels == 0 && decisions == 0, stable);
  }
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
  TestTranslation();
  TestShadows();
  return rtwTestResult();
}
