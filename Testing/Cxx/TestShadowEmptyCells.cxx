// SPDX-License-Identifier: BSD-3-Clause
// Columns and rows in which nothing is seen get next to nothing of the map, as their twin says, and
// what is seen starves of nothing.
#include "rtwImportanceScene.h"

#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr int Parts = 128; // of each axis, of which one is in use or not
constexpr double Sigma = 3;
constexpr int Resolution = 512;

// Three small floors far from each other along both axes, with a box above each.
struct Islands : rtwImportanceScene
{
  explicit Islands(bool spot)
    : rtwImportanceScene(false)
  {
    this->Renderer->RemoveAllViewProps();
    for (const double at : { -6.0, 0.5, 6.0 })
    {
      vtkNew<vtkPlaneSource> plane;
      plane->SetOrigin(at - 0.7, 0, 0.8 * at + 0.7);
      plane->SetPoint1(at + 0.7, 0, 0.8 * at + 0.7);
      plane->SetPoint2(at - 0.7, 0, 0.8 * at - 0.7);
      this->Add(plane);
      this->AddBox(at, 0.8, 0.8 * at, 0.4);
    }
    this->Light = spot ? this->AddSpot(1, 12, 2, 50) : this->AddSun(1, 6, 2);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 12, 10);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewAngle(45);
    this->Window->SetSize(400, 400);
    this->Pass->SetResolution(Resolution);
    this->Warped->SetBlurSigma(Sigma);
    this->Warped->SetImportanceFloor(0.2);
  }

  // Which parts of the focus any pixel sees.
  std::vector<bool> UsedParts(int axis)
  {
    vtkNew<vtkMatrix4x4> toPlane;
    this->Warped->GetLightPlaneMatrix(0, 0, toPlane);
    std::vector<bool> used(Parts, false);
    for (const rtw::ViewSample& sample :
      rtw::ShadowReference(this->Renderer).Samples(this->Light, 400, 400))
    {
      double at[4] = { sample.Position.x, sample.Position.y, sample.Position.z, 1 };
      toPlane->MultiplyPoint(at, at);
      used[std::clamp(int(at[axis] / at[3] * Parts), 0, Parts - 1)] = true;
    }
    return used;
  }

  Maps MapsWhileCulling(bool culling)
  {
    this->Warped->SetCullEmptyCells(culling);
    this->Render();
    return this->GetMaps();
  }

  vtkLight* Light;
};

int CountCulled(const std::vector<double>& map)
{
  int culled = 0;
  for (std::size_t i = 0; i + 1 < map.size(); ++i)
  {
    culled += map[i + 1] - map[i] < 4 * rtw::LeastShare;
  }
  return culled;
}

// From what is in use to what is culled it is farther on the map than a filter looks.
void CheckReach(const std::vector<double>& map, const std::vector<bool>& used, double texels)
{
  const int cells = static_cast<int>(map.size()) - 1;
  double least = 1e9;
  for (int part = 0; part < Parts; ++part)
  {
    const int start = part * cells / Parts, end = (part + 1) * cells / Parts;
    for (int cell = 0; used[part] && cell < cells; ++cell)
    {
      if (map[cell + 1] - map[cell] < 4 * rtw::LeastShare)
      {
        least = std::min(least, cell < start ? map[start] - map[cell + 1] : map[cell] - map[end]);
      }
    }
  }
  std::cout << "culled " << least * Resolution << " texels away, a filter looks " << texels
            << std::endl;
  RTW_CHECK(least * Resolution >= texels);
}

void TestTwin(bool spot)
{
  Islands scene(spot);
  scene.Name = spot ? "twin, spot" : "twin, sun";
  const rtwImportanceScene::Maps plain = scene.MapsWhileCulling(false);
  const rtwImportanceScene::Maps culled = scene.MapsWhileCulling(true);
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::vector<bool> used = scene.UsedParts(axis);
    const rtw::WarpingFunction twin = rtw::WarpingFunction::FromValues(plain[axis])
                                        .Culled(used, Sigma, rtw::NeighbourReach / Resolution);
    double most = 0, moved = 0;
    for (std::size_t i = 0; i < culled[axis].size(); ++i)
    {
      most = std::max(most, std::abs(culled[axis][i] - twin.GetValues()[i]));
      moved = std::max(moved, std::abs(culled[axis][i] - plain[axis][i]));
    }
    const int culledCells = CountCulled(culled[axis]);
    std::cout << scene.Name << ", axis " << axis << ": " << culledCells
              << " cells culled, values moved by " << moved << ", off the twin by " << most
              << std::endl;
    RTW_CHECK(culledCells > 100);
    RTW_CHECK(moved > 0.02);
    // A part at a rim may be in use or not, by a pixel.
    RTW_CHECK(most < 2e-3);
    CheckReach(culled[axis], used, 1);
  }
}

// Wide filters reach beyond what is seen.
void TestFilters(bool spot)
{
  Islands scene(spot);
  rtwShadowBounds bounds;
  struct
  {
    const char* Name;
    int Filter;
    double Radius, Texels, Wrong;
  } const filters[] = { { "nearest", vtkAdaptiveShadowMapPass::NEAREST, 0, 1, 0.5 },
    { "bilinear", vtkAdaptiveShadowMapPass::BILINEAR, 0, 1, 0.3 },
    { "pcf 8", vtkAdaptiveShadowMapPass::PCF, 8, 9, 1 },
    { "soft", vtkAdaptiveShadowMapPass::SOFT, 0.15, 1, 1 } };
  for (const auto& filter : filters)
  {
    scene.Name = std::string(filter.Name) + (spot ? ", spot" : ", sun");
    scene.Pass->SetFilter(filter.Filter);
    scene.Pass->SetFilterRadius(filter.Radius);
    bounds.Wrong = filter.Wrong;
    bounds.Undecided = 0.5; // a filter's exact half
    const rtwImportanceScene::Maps plain = scene.MapsWhileCulling(false);
    RTW_CHECK_SHADOWS_WITHIN(scene, scene.Light, 0, bounds);
    const rtwImportanceScene::Maps culled = scene.MapsWhileCulling(true);
    RTW_CHECK_SHADOWS_WITHIN(scene, scene.Light, 0, bounds);
    for (int axis = 0; axis < 2; ++axis)
    {
      CheckReach(culled[axis], scene.UsedParts(axis), filter.Texels);
    }
  }
}

// Nothing is culled where receivers may be seen that no sample is of, nor what translucent ones
// may need.
void TestUnsampled()
{
  Islands scene(false);
  const rtwImportanceScene::Maps plain = scene.MapsWhileCulling(false);
  rtwCheckApart("sampled", scene.MapsWhileCulling(true), plain);
  scene.Pass->SetViewSampleSourceToPreviousFrame();
  scene.Render();
  rtwCheckAlike("previous frame", scene.MapsWhileCulling(true), scene.MapsWhileCulling(false));
  scene.Pass->SetViewSampleSourceToPrepass();
  scene.Window->SetMultiSamples(4);
  rtwCheckAlike(
    "several samples a pixel", scene.MapsWhileCulling(true), scene.MapsWhileCulling(false));
  scene.Window->SetMultiSamples(0);
  scene.AddBox(0, 0.05, 0, 12)->GetProperty()->SetOpacity(0.3);
  const rtwImportanceScene::Maps culled = scene.MapsWhileCulling(true);
  RTW_CHECK_EQUAL(CountCulled(culled[0]) + CountCulled(culled[1]), 0);
}
}

int TestShadowEmptyCells(int, char*[])
{
  for (const bool spot : { false, true })
  {
    TestTwin(spot);
    TestFilters(spot);
  }
  TestUnsampled();
  return rtwTestResult();
}
