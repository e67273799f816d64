// SPDX-License-Identifier: BSD-3-Clause
// Layers by depth beside exact rays: lights of both kinds and several of them under each warp, what
// only VTK's mappers draw, receivers that look shadows up themselves, and the faces of the frustum.
#include "rtwCascadeStage.h"
#include "rtwEachTechnique.h"

#include "vtkCascadedShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkNonOrthogonalShadowMapWarp.h"
#include "vtkPerspectiveShadowMapWarp.h"
#include "vtkProperty.h"
#include "vtkRectilinearShadowMapWarp.h"

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
void SetWarp(rtwShadowStage& stage, const std::string& name)
{
  if (name == "perspective")
  {
    vtkNew<vtkPerspectiveShadowMapWarp> warp;
    stage.Pass->SetWarp(warp);
  }
  else if (name == "rtw")
  {
    vtkNew<vtkRectilinearShadowMapWarp> warp;
    stage.Pass->SetWarp(warp);
  }
  else if (name == "notw")
  {
    vtkNew<vtkNonOrthogonalShadowMapWarp> warp;
    stage.Pass->SetWarp(warp);
  }
}

void TestLights(rtwChain chain, const std::string& warp)
{
  rtwShadowStage stage(rtwTechnique::Cascades, chain);
  stage.Name = "lights " + warp + " " + rtwNameOf(chain);
  SetWarp(stage, warp);
  rtwCheckLights(stage);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 12);
  RTW_CHECK_PICTURE(stage);
}

// Of what VTK's mappers draw each layer has another one where the warp bends.
void TestGlyphs(const std::string& warp)
{
  rtwShadowStage stage(rtwTechnique::Cascades);
  stage.Name = "glyphs " + warp;
  SetWarp(stage, warp);
  rtwCheckGlyphs(stage);
}

// What looks shadows up itself, because it is translucent or because pixels have several samples or
// masks are not made, has those that one fine layer has.
void TestReceivers(const char* name, void change(rtwShadowStage&))
{
  rtwCascadeStage stage(name);
  auto* pass = stage.GetPass();
  pass->SetResolution(2048);
  change(stage);
  vtkSmartPointer<vtkImageData> pictures[2];
  for (const int layers : { 1, 4 })
  {
    pass->SetNumberOfLayers(layers);
    stage.Render();
    stage.Render(); // one that has a frame before
    pictures[layers > 1] = rtwGrab(stage.Window);
  }
  const int* size = stage.Window->GetSize();
  int different = 0, shaded = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto one = rtwPixel(pictures[0], x, y), four = rtwPixel(pictures[1], x, y);
      different += std::abs(one[0] - four[0]) > 60;
      shaded += four[0] < 60;
    }
  }
  std::cout << name << ": " << different << " pixels differ from those of one layer, " << shaded
            << " are dark" << std::endl;
  RTW_CHECK(different < 250);
  RTW_CHECK(shaded > 500);
}

// Layers of each face and depth, seen with the light, against it, and across.
void TestFaces()
{
  for (const std::string warp : { "identity", "perspective", "rtw" })
  {
    for (const glm::dvec3& from :
      { glm::dvec3(0.6, 4, 8), glm::dvec3(-2, 5, -7), glm::dvec3(3, 5, 1) })
    {
      rtwShadowStage stage(rtwTechnique::Cascades);
      stage.Name = "faces " + warp + " z " + std::to_string(from.z);
      SetWarp(stage, warp);
      stage.AddObjects();
      vtkLight* sun = stage.AddSun(from.x, from.y, from.z);
      vtkLight* spot = stage.AddSpot(from.x, from.y, from.z, 40);
      auto* pass = vtkCascadedShadowMapPass::SafeDownCast(stage.Pass);
      pass->SetNumberOfLayers(2);
      pass->SplitFacesOn();
      stage.Render();
      RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 16);
      RTW_CHECK_EQUAL(pass->GetNumberOfLightLayers(1), 8);
      rtwShadowBounds bounds;
      bounds.Shadowed = 0.5;
      RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
      RTW_CHECK_SHADOWS_WITHIN(stage, spot, 1, bounds);
      pass->SetBlendWidth(0.5);
      pass->SetNumberOfLayers(1);
      stage.Render();
      RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 8);
      RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
    }
  }
}
}

int TestCascades(int, char*[])
{
  for (const char* warp : { "identity", "perspective", "rtw", "notw" })
  {
    TestLights(rtwChain::Steps, warp);
    TestGlyphs(warp);
  }
  TestLights(rtwChain::Classic, "rtw");
  TestReceivers("opaque", [](rtwShadowStage&) {});
  TestReceivers("translucent floor", [](rtwShadowStage& stage) {
    stage.Renderer->GetActors()->GetLastActor()->GetProperty()->SetOpacity(0.7);
  });
  TestReceivers("previous frame",
    [](rtwShadowStage& stage) { stage.Pass->SetViewSampleSourceToPreviousFrame(); });
  TestReceivers("multisampled", [](rtwShadowStage& stage) { stage.Window->SetMultiSamples(4); });
  TestFaces();
  return rtwTestResult();
}
