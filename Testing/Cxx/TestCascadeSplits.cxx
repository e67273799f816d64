// SPDX-License-Identifier: BSD-3-Clause
// Layers by depth: where depths are split, what is culled, what is blended, what is shown of them,
// and settings.
#include "rtwCascadeStage.h"

#include "vtkCamera.h"
#include "vtkCascadedShadowMapPass.h"
#include "vtkDepthSplitShadowMapPartition.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
// Between the nearest and the farthest thing that faces the light, as the scheme says.
void TestSplits()
{
  rtwCascadeStage stage("splits");
  auto* pass = stage.GetPass();
  stage.Pass->SetViewSampleStride(1);
  const glm::dvec2 range = stage.FindDepths();
  for (const int scheme : { vtkCascadedShadowMapPass::UNIFORM,
         vtkCascadedShadowMapPass::LOGARITHMIC, vtkCascadedShadowMapPass::PRACTICAL })
  {
    for (const int layers : { 2, 5, 8 })
    {
      pass->SetSplitScheme(scheme);
      pass->SetLambda(0.3);
      pass->SetNumberOfLayers(layers);
      stage.Render();
      RTW_CHECK_EQUAL(pass->GetNumberOfLightLayers(0), layers);
      RTW_CHECK(stage.GetRange(0, 0).x <= 0);
      RTW_CHECK(stage.GetRange(0, layers - 1).y > 1e30);
      const double lambda = scheme == vtkCascadedShadowMapPass::UNIFORM ? 0
        : scheme == vtkCascadedShadowMapPass::PRACTICAL                 ? 0.3
                                                                        : 1;
      for (int k = 1; k < layers; ++k)
      {
        const double share = double(k) / layers;
        const double expected = lambda * range.x * std::pow(range.y / range.x, share) +
          (1 - lambda) * (range.x + (range.y - range.x) * share);
        RTW_CHECK_NEAR(stage.GetRange(0, k).x / expected, 1, 2e-3);
        RTW_CHECK_EQUAL(stage.GetRange(0, k).x, stage.GetRange(0, k - 1).y);
      }
    }
  }
}

// What samples decide is better than what they don't.
void TestSampleDistribution()
{
  rtwCascadeStage stage("sample distribution");
  auto* pass = stage.GetPass();
  pass->SetNumberOfLayers(3);
  const double adapted = stage.Measure();
  for (int k = 1; k < 3; ++k)
  {
    RTW_CHECK_EQUAL(stage.GetRange(0, k).x, stage.GetRange(0, k - 1).y);
    RTW_CHECK(stage.GetRange(0, k).x > stage.GetRange(0, k - 1).x);
  }
  for (const int scheme :
    { vtkCascadedShadowMapPass::UNIFORM, vtkCascadedShadowMapPass::LOGARITHMIC })
  {
    pass->SetSplitScheme(scheme);
    RTW_CHECK(adapted < stage.Measure());
  }
}

// Each layer draws what reaches it, and one that nobody looks at nothing.
void TestCulling()
{
  rtwCascadeStage stage("culling");
  // The far floor would be seen everywhere.
  stage.Renderer->GetActors()->GetLastActor()->VisibilityOff();
  auto* pass = stage.GetPass();
  pass->SetNumberOfLayers(8);
  pass->SetSplitSchemeToUniform();
  stage.Render();
  int drawn = 0, total = -1, empty = 0;
  for (int k = 0; k < 8; ++k)
  {
    const int here = pass->GetNumberOfCastersDrawn(0, k);
    const int all = here + pass->GetNumberOfCastersCulled(0, k);
    RTW_CHECK(total < 0 || all == total);
    total = all;
    drawn += here;
    empty += here == 0;
  }
  std::cout << "culling: " << drawn << " of " << total << " casters in 8 layers, " << empty
            << " of which are empty" << std::endl;
  RTW_CHECK(total >= 12);
  RTW_CHECK(empty >= 3);
  RTW_CHECK(drawn < 3 * total);
  RTW_CHECK_EQUAL(pass->GetNumberOfCastersDrawn(0), drawn);
  RTW_CHECK_EQUAL(pass->GetNumberOfCastersDrawn(0, 8), 0);
  rtwShadowBounds bounds;
  bounds.Shadowed = 0;
  bounds.Far = 0.05;
  RTW_CHECK_SHADOWS_WITHIN(stage, stage.Sun, 0, bounds);
}

// Between where blending starts and the split shadows are of both layers, and nowhere else.
void TestBlending()
{
  rtwCascadeStage stage("blending");
  for (int i = 0; i < 16; ++i)
  {
    stage.AddBox(i % 2 ? 3.0 : -3.0, 0.5, -3.0 * i, 1.0);
  }
  auto* pass = stage.GetPass();
  pass->SetSplitSchemeToLogarithmic();
  pass->SetFilterToNearest();
  pass->SetResolution(128);
  const double nearest = stage.FindDepths().x;
  for (const double width : { 0.0, 0.4 })
  {
    pass->SetBlendWidth(width);
    stage.Render();
    const std::vector<unsigned char> mask = stage.GetMask(0);
    std::vector<glm::dvec2> bands;
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec2 range = stage.GetRange(0, k);
      bands.emplace_back(range.y - width * (range.y - std::max(range.x, nearest)), range.y);
    }
    int inside = 0, outside = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      const double depth = stage.Depths[i];
      const bool isInBand = std::any_of(bands.begin(), bands.end(),
        [&](const glm::dvec2& band) { return depth > 0.998 * band.x && depth < 1.002 * band.y; });
      const bool isBetween = mask[i] != 0 && mask[i] != 128 && mask[i] != 255;
      inside += isBetween && isInBand;
      outside += isBetween && !isInBand;
    }
    std::cout << "blending " << width << ": " << inside << " pixels of both layers in the bands, "
              << outside << " elsewhere" << std::endl;
    RTW_CHECK_EQUAL(inside > 10, width > 0);
    RTW_CHECK_EQUAL(outside, 0);
  }
}

// Each layer's colour where it is looked up, and no other.
void TestLayersView()
{
  rtwCascadeStage stage("layers view");
  auto* pass = stage.GetPass();
  pass->SetNumberOfLayers(3);
  pass->SetSplitSchemeToLogarithmic();
  pass->SetDebugViewToLayers();
  stage.FindDepths();
  stage.Render();
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(stage.Window);
  const glm::dvec3 colours[] = { { 0.30, 0.62, 0.85 }, { 0.95, 0.60, 0.20 }, { 0.40, 0.75, 0.35 } };
  const std::vector<glm::dvec2> ranges{ stage.GetRange(0, 0), stage.GetRange(0, 1),
    stage.GetRange(0, 2) };
  int width = stage.Window->GetSize()[0], looked[3] = {}, wrong = 0;
  for (std::size_t i = 0; i < stage.Depths.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (stage.Depths[i] > 1.01 * ranges[k].x && stage.Depths[i] < 0.99 * ranges[k].y)
      {
        const auto c = rtwPixel(picture, int(i) % width, int(i) / width);
        const glm::dvec3 colour = glm::normalize(glm::dvec3(c[0], c[1], c[2]));
        ++looked[k];
        wrong += glm::length(colour - glm::normalize(colours[k])) > 0.05;
      }
    }
  }
  std::cout << "layers view: " << looked[0] << ", " << looked[1] << " and " << looked[2]
            << " pixels, " << wrong << " of another colour" << std::endl;
  RTW_CHECK(std::min({ looked[0], looked[1], looked[2] }) > 1000);
  RTW_CHECK(wrong < 50);
}

// What is drawn again when, and what is asked of layers that there aren't.
void TestSettings()
{
  rtwCascadeStage stage("settings");
  auto* pass = stage.GetPass();
  stage.Render();
  const double fine = pass->GetMaximumEffectiveResolution(0, 0);
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 4);
  stage.Render();
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersReused(), 4);
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 0);
  pass->SetNumberOfLayers(2);
  stage.Render();
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 2);
  RTW_CHECK(pass->GetMaximumEffectiveResolution(0, 0) < fine);
  RTW_CHECK(pass->GetShadowMapImage(0, 1) != nullptr);
  RTW_CHECK(pass->GetShadowMapImage(0, 2) == nullptr);
  RTW_CHECK(pass->GetWarpImage(0, -1) == nullptr);
  double range[2] = { 7, 7 };
  RTW_CHECK(!pass->GetLayerDepthRange(0, 2, range));
  RTW_CHECK_EQUAL(range[0], 7);
  pass->SetNumberOfLayers(1);
  stage.Render();
  RTW_CHECK_EQUAL(pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_EQUAL(pass->GetNumberOfLightLayers(1), 0);
  // From below the sun shines on nothing of the floor that is seen: no layer has a sample.
  stage.Sun->SetPosition(0.3, -1, 0.2);
  stage.Renderer->GetActiveCamera()->SetPosition(0, 30, -30);
  stage.Renderer->GetActiveCamera()->SetFocalPoint(0, 0, -30.1);
  stage.Renderer->ResetCameraClippingRange();
  pass->SetNumberOfLayers(4);
  stage.Render();
  const std::vector<unsigned char> mask = stage.GetMask(0);
  RTW_CHECK(std::all_of(mask.begin(), mask.end(), [](int value) { return value == 128; }));
  RTW_CHECK_EQUAL(pass->GetNumberOfCastersDrawn(0), 0);
}

void TestBadInput()
{
  rtwCascadeStage stage("bad input");
  auto* pass = stage.GetPass();
  vtkDepthSplitShadowMapPartition* splits = pass->GetDepthSplits();
  rtwMessageCatcher messages(splits);
  splits->SetSplitScheme(4);
  splits->SetSplitScheme(-1);
  splits->SetLambda(std::numeric_limits<double>::quiet_NaN());
  splits->SetBlendWidth(std::numeric_limits<double>::infinity());
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 4);
  RTW_CHECK_EQUAL(splits->GetSplitScheme(), vtkDepthSplitShadowMapPartition::SAMPLE_DISTRIBUTION);
  RTW_CHECK_EQUAL(splits->GetLambda(), 0.5);
  splits->SetLambda(7);
  RTW_CHECK_EQUAL(splits->GetLambda(), 1.0);
  splits->SetNumberOfLayers(0);
  RTW_CHECK_EQUAL(splits->GetNumberOfLayers(), 1);
  splits->SetNumberOfLayers(99);
  RTW_CHECK_EQUAL(splits->GetNumberOfLayers(), 8);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, stage.Sun, 0);
  rtwMessageCatcher passMessages(pass);
  pass->SetPartition(nullptr);
  RTW_CHECK_EQUAL(passMessages.GetNumberOfErrors(), 1);
  RTW_CHECK(pass->GetPartition() == splits);
}
}

int TestCascadeSplits(int, char*[])
{
  TestSplits();
  TestSampleDistribution();
  TestCulling();
  TestBlending();
  TestLayersView();
  TestSettings();
  TestBadInput();
  return rtwTestResult();
}
