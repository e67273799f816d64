// SPDX-License-Identifier: BSD-3-Clause
// Percentage-closer filtering on the map.
#include "rtwShadowProfile.h"

#include "vtkImageData.h"
#include "vtkProperty.h"

#include <cmath>
#include <iostream>

namespace
{
void Fill(rtwShadowStage& stage)
{
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  stage.Pass->SetResolution(256);
}

void TestPicture(int argc, char* argv[])
{
  rtwShadowStage stage;
  Fill(stage);
  stage.Pass->SetFilterToPCF();
  stage.Pass->SetFilterRadius(4);
  stage.Render();
  rtwCompareWithBaseline(stage.Window, argc, argv);
}

// Radius 0 is BILINEAR to the last bit.
void TestRadiusZero(rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  Fill(stage);
  stage.Render();
  const std::vector<unsigned char> bilinear = stage.GetMask(0);
  for (const int filter : { vtkAdaptiveShadowMapPass::PCF, vtkAdaptiveShadowMapPass::SOFT })
  {
    stage.Pass->SetFilter(filter);
    stage.Pass->SetFilterRadius(0);
    stage.Render();
    RTW_CHECK(stage.GetMask(0) == bilinear);
    stage.Pass->SetFilterRadius(1);
    stage.Render();
    RTW_CHECK(stage.GetMask(0) != bilinear);
  }
}

// Across the box's shadow, whose edge runs along no axis of the map.
void TestProfile(rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  stage.AddFloor();
  stage.AddBox(-2, 1.5, 0, 3);
  stage.AddSun(-3, 6, 1);
  stage.Window->SetSize(450, 300);
  stage.Pass->SetResolution(256);
  stage.Pass->SetFilterToPCF();
  double last = 0;
  for (const double radius : { 0.5, 1.0, 2.0, 4.0, 8.0 })
  {
    stage.Pass->SetFilterRadius(radius);
    stage.Render();
    const double from[] = { 0.2, 0, -0.4 }, to[] = { 2.8, 0, -0.2 };
    const std::vector<double> profile = rtwProfile(stage, from, to, 200);
    const double width = rtwWidth(profile);
    std::cout << "PCF of " << radius << " texels: " << width << " wide, steepest "
              << rtwSteepest(profile) << std::endl;
    RTW_CHECK(rtwIsMonotone(profile));
    RTW_CHECK(width > 1.15 * last);
    // Of even steps, each would be 0.8 of the light over as many places as the width has.
    RTW_CHECK(rtwSteepest(profile) < 1.6 * 0.8 / (width * 199));
    last = width;
  }
}

// No pixel's taps are better than another's: as much light is left in all, and a still frame stays
// still. A regular lattice's share of the light hangs on where it meets the edges: the mean of some
// radii doesn't.
void TestJitter(int filter, const std::vector<double>& radii)
{
  rtwShadowStage stage;
  Fill(stage);
  stage.Pass->CachingOff();
  stage.Pass->SetFilter(filter);
  double share = 0, jitteredShare = 0;
  for (const double radius : radii)
  {
    stage.Pass->SetFilterRadius(radius);
    stage.Pass->FilterJitterOff();
    stage.Render();
    const std::vector<unsigned char> regular = stage.GetMask(0);
    stage.Pass->FilterJitterOn();
    stage.Render();
    const std::vector<unsigned char> jittered = stage.GetMask(0);
    stage.Render();
    RTW_CHECK(stage.GetMask(0) == jittered);
    RTW_CHECK(jittered != regular);
    share += rtwMeanVisibility(regular) / double(radii.size());
    jitteredShare += rtwMeanVisibility(jittered) / double(radii.size());
  }
  std::cout << "mean visibility " << share << ", jittered " << jitteredShare << std::endl;
  RTW_CHECK_NEAR(jitteredShare, share, 5e-4);
}

// Sets filter and radius; true where a mapper had to build shaders.
bool Builds(rtwShadowStage& stage, int filter, double radius)
{
  const int before = stage.Pass->GetNumberOfShaderBuilds();
  stage.Pass->SetFilter(filter);
  stage.Pass->SetFilterRadius(radius);
  stage.Render();
  return stage.Pass->GetNumberOfShaderBuilds() > before;
}

void TestShaderBuilds()
{
  rtwShadowStage stage;
  Fill(stage);
  stage.AddBall(0, 1, 2, 0.4)->GetProperty()->SetOpacity(0.5);
  Builds(stage, vtkAdaptiveShadowMapPass::PCF, 2);
  RTW_CHECK(!Builds(stage, vtkAdaptiveShadowMapPass::PCF, 2));
  RTW_CHECK(!Builds(stage, vtkAdaptiveShadowMapPass::PCF, 5));
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK(!Builds(stage, vtkAdaptiveShadowMapPass::PCF, 0));
  stage.Pass->FilterJitterOn();
  RTW_CHECK(!Builds(stage, vtkAdaptiveShadowMapPass::PCF, 8));
  RTW_CHECK(Builds(stage, vtkAdaptiveShadowMapPass::SOFT, 0.5));
  RTW_CHECK(!Builds(stage, vtkAdaptiveShadowMapPass::SOFT, 0.1));
}

// Mappers that look the shadow up themselves, because of the samples of a pixel, see what the mask
// says.
void TestDirect(int filter, double radius)
{
  vtkSmartPointer<vtkImageData> pictures[2];
  for (const int samples : { 0, 4 })
  {
    rtwShadowStage stage;
    Fill(stage);
    stage.Window->SetMultiSamples(samples);
    stage.Pass->SetFilter(filter);
    stage.Pass->SetFilterRadius(radius);
    stage.Render();
    pictures[samples / 4] = rtwGrab(stage.Window);
  }
  int differ = 0, grey = 0;
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 300; ++x)
    {
      const int masked = rtwPixel(pictures[0], x, y)[0], direct = rtwPixel(pictures[1], x, y)[0];
      grey += masked > 20 && masked < 180;
      differ += std::abs(masked - direct) > 6;
    }
  }
  std::cout << differ << " of 60000 pixels differ, " << grey << " are grey" << std::endl;
  // At the outlines of things, and nowhere else.
  RTW_CHECK(differ < 600);
  RTW_CHECK(grey > 2000);
}
}

int TestShadowPCF(int argc, char* argv[])
{
  TestPicture(argc, argv);
  for (const rtwTechnique technique : { rtwTechnique::Uniform, rtwTechnique::RTW })
  {
    TestRadiusZero(technique);
    TestProfile(technique);
  }
  TestJitter(vtkAdaptiveShadowMapPass::PCF, { 4, 6, 8 });
  TestJitter(vtkAdaptiveShadowMapPass::SOFT, { 0.4, 0.45, 0.5, 0.55, 0.6 });
  TestShaderBuilds();
  TestDirect(vtkAdaptiveShadowMapPass::PCF, 6);
  TestDirect(vtkAdaptiveShadowMapPass::SOFT, 0.4);
  return rtwTestResult();
}
