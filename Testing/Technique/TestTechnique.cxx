// SPDX-License-Identifier: BSD-3-Clause
// A technique of its own, which the module doesn't know: its shadows beside exact rays, and its map
// beside the conventional one, which has the same depths in other places.
#include "rtwEachTechnique.h"

#include "rtwFovealWarpStage.h"
#include "vtkFovealShadowMapPass.h"
#include "vtkFovealShadowMapWarp.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace
{
void TestRasterization()
{
  rtwShadowStage stage(vtkSmartPointer<vtkFovealShadowMapPass>::New());
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  for (const int way : { vtkAdaptiveShadowMapPass::AUTOMATIC, vtkAdaptiveShadowMapPass::EXACT,
         vtkAdaptiveShadowMapPass::TESSELLATED })
  {
    stage.Name = "rasterization " + std::to_string(way);
    stage.Pass->SetRasterization(way);
    stage.Pass->SetMaximumEdgeLength(0.01);
    stage.Render();
    RTW_CHECK_SHADOWS(stage, sun, 0);
  }
}

void TestSettings()
{
  rtwShadowStage stage(vtkSmartPointer<vtkFovealShadowMapPass>::New());
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  for (const unsigned int resolution : { 512u, 1000u, 2048u })
  {
    stage.Name = "resolution " + std::to_string(resolution);
    stage.Pass->SetResolution(resolution);
    stage.Render();
    rtwShadowBounds bounds;
    bounds.Wrong *= std::max(1.0, 1024.0 / resolution);
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  }
}

// The warp may be that of any partition's layers.
void TestCascades()
{
  rtwShadowStage stage(rtwTechnique::Cascades);
  stage.Name = "cascades";
  vtkNew<vtkFovealShadowMapWarp> warp;
  stage.Pass->SetWarp(warp);
  rtwCheckLights(stage);
}

vtkSmartPointer<vtkImageData> DrawMap(rtwShadowStage& stage)
{
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  stage.Pass->CullCastersOff();
  stage.Render();
  return stage.Pass->GetShadowMapImage(0);
}

// The share of a map's texels that have the depth of another's: at the same place, or where the
// warp takes it from.
double ShareOfSame(vtkImageData* map, vtkImageData* even, bool warped)
{
  const int side = map->GetDimensions()[0];
  const auto depth = [](vtkImageData* image, int i, int j) {
    return *static_cast<float*>(image->GetScalarPointer(i, j, 0));
  };
  const auto source = [side, warped](int texel) {
    const double at = rtw::FovealFunction::Inverse((texel + 0.5) / side);
    return warped ? std::clamp(static_cast<int>(at * side), 0, side - 1) : texel;
  };
  int same = 0;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      same += std::abs(depth(map, i, j) - depth(even, source(i), source(j))) < 1e-3;
    }
  }
  return same / (double(side) * side);
}

// A texel at y on the warped map shows what is at the inverse of y on the conventional one, also on
// a floor of two triangles, whose edges the warp bends: drawn straight, they leave it.
void TestMap()
{
  rtwShadowStage uniform(rtwTechnique::Uniform);
  rtwShadowStage foveal(vtkSmartPointer<vtkFovealShadowMapPass>::New()),
    straight(vtkSmartPointer<vtkFovealShadowMapPass>::New());
  straight.Pass->SetRasterizationToLinear();
  const vtkSmartPointer<vtkImageData> even = DrawMap(uniform), warped = DrawMap(foveal),
                                      linear = DrawMap(straight);
  if (!RTW_CHECK(even && warped && linear))
  {
    return;
  }
  RTW_CHECK_EQUAL(even->GetDimensions()[0], warped->GetDimensions()[0]);
  const double here = ShareOfSame(warped, even, false), there = ShareOfSame(warped, even, true),
               drawnStraight = ShareOfSame(linear, even, true);
  std::cout << "map: " << here << " of its texels are as the conventional map's, " << there
            << " as those that the warp puts there; with straight edges " << drawnStraight
            << std::endl;
  RTW_CHECK(here < 0.5);
  RTW_CHECK(there > 0.99);
  RTW_CHECK(drawnStraight < 0.9);
  RTW_CHECK(foveal.Pass->GetMaximumEffectiveResolution(0, 0) >
    1.2 * uniform.Pass->GetMaximumEffectiveResolution(0, 0));
}

void TestFunction()
{
  double last = -1;
  for (double x = -0.5; x <= 1.5; x += 0.01)
  {
    const double y = rtw::FovealFunction::Forward(x);
    RTW_CHECK(y > last);
    RTW_CHECK_NEAR(rtw::FovealFunction::Inverse(y), x, 1e-12);
    last = y;
  }
  RTW_CHECK_NEAR(rtw::FovealFunction::Forward(0), 0, 1e-12);
  RTW_CHECK_NEAR(rtw::FovealFunction::Forward(1), 1, 1e-12);
}

int TestTechnique()
{
  TestFunction();
  TestMap();
  rtwCheckTechnique({ "foveal", vtkSmartPointer<vtkFovealShadowMapPass>::New, {} });
  TestRasterization();
  TestSettings();
  TestCascades();
  return rtwTestResult();
}
}

int main(int argc, char* argv[])
{
  rtwTestBegin(argc, argv);
  return rtwTestEnd(TestTechnique());
}
