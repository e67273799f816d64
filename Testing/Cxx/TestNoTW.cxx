// SPDX-License-Identifier: BSD-3-Clause
// Non-orthogonal texture warping beside exact rays: floors of two triangles, the ways of
// rasterizing, and its settings.
#include "rtwDeepStage.h"
#include "Warp/NonOrthogonal/rtwNonOrthogonalWarp.h"

#include "vtkImageData.h"
#include "vtkNonOrthogonalShadowMapWarp.h"
#include "vtkNoTWShadowMapPass.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{
vtkNonOrthogonalShadowMapWarp* WarpOf(rtwShadowStage& stage)
{
  return vtkNoTWShadowMapPass::SafeDownCast(stage.Pass)->GetNonOrthogonalWarp();
}

struct Deep : rtwDeepStage
{
  explicit Deep(int floorCells)
    : rtwDeepStage(rtwTechnique::NoTW, floorCells)
  {
  }

  double Measure(const char* name)
  {
    const rtw::ShadowErrors errors = this->Compare(name);
    return errors.Percent(errors.Wrong());
  }
};

// A floor takes the same texels whatever triangles it is of: none is left out at their edges.
void TestMaps()
{
  std::vector<float> expected;
  for (const int cells : { 1, 3, 10, 31, 100 })
  {
    Deep stage(cells);
    stage.Pass->CullCastersOff(); // the floor hides nothing that is seen
    stage.Render();
    const vtkSmartPointer<vtkImageData> map = stage.Pass->GetShadowMapImage(0);
    const auto* depths = static_cast<float*>(map->GetScalarPointer());
    const std::vector<float> found(depths, depths + map->GetNumberOfPoints());
    if (expected.empty())
    {
      expected = found;
    }
    int holes = 0, empty = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      empty += found[i] == 1;
      holes += (found[i] == 1) != (expected[i] == 1);
    }
    std::cout << "map of a floor of " << 2 * cells * cells << ": " << holes << " holes, "
              << empty << " empty" << std::endl;
    RTW_CHECK(empty < 0.5 * double(found.size()));
    RTW_CHECK(holes <= 4); // by rounding, at the floor's end
  }
}

// Triangles that the warp bends a lot are as right as small ones.
void TestRasterization()
{
  Deep coarse(1), fine(120);
  const double exact = coarse.Measure("floor of 2 triangles");
  RTW_CHECK_NEAR(exact, fine.Measure("floor of 28800"), 0.05);
  coarse.Pass->SetRasterizationToExact();
  RTW_CHECK_NEAR(coarse.Measure("exact"), exact, 0.02);
  coarse.Pass->SetRasterizationToTessellated();
  coarse.Pass->SetMaximumEdgeLength(0.01);
  RTW_CHECK(coarse.Measure("tessellated") < 2 * exact + 0.5);
  // What the two are better than.
  coarse.Pass->SetRasterizationToLinear();
  RTW_CHECK(coarse.Measure("linear") > 10 * exact);
}

// Each function rises from 0 to 1; neighbours differ the less, the smoother.
double LargestStep(rtwShadowStage& stage, int cells)
{
  const vtkSmartPointer<vtkImageData> functions = stage.Pass->GetWarpImage(0);
  if (!RTW_CHECK(functions != nullptr))
  {
    return 0;
  }
  const int* size = functions->GetDimensions();
  RTW_CHECK_EQUAL(size[0], cells + 1);
  RTW_CHECK_EQUAL(size[1], cells);
  RTW_CHECK_EQUAL(size[2], 2);
  const auto at = [&](int border, int line, int axis) {
    return *static_cast<float*>(functions->GetScalarPointer(border, line, axis));
  };
  double most = 0;
  int falling = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int line = 0; line < cells; ++line)
    {
      falling += at(0, line, axis) != 0 || std::abs(at(cells, line, axis) - 1) > 1e-6;
      for (int i = 0; i < cells; ++i)
      {
        falling += !(at(i + 1, line, axis) > at(i, line, axis));
        const double step = line > 0 ? at(i, line, axis) - at(i, line - 1, axis) : 0;
        most = std::max(most, std::abs(step));
      }
    }
  }
  RTW_CHECK_EQUAL(falling, 0);
  return most;
}

// What was collected is as much along s as along t where samples are counted, and functions are as
// steep as what was used.
void TestImportance()
{
  rtwShadowStage stage(rtwTechnique::NoTW);
  stage.Name = "importance";
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  WarpOf(stage)->SetWeightsToCount();
  WarpOf(stage)->SetImportanceResolution(128);
  stage.Render();
  const vtkSmartPointer<vtkImageData> importance = stage.Pass->GetImportanceImage(0);
  const vtkSmartPointer<vtkImageData> functions = stage.Pass->GetWarpImage(0);
  if (!RTW_CHECK(importance && functions))
  {
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    RTW_CHECK_EQUAL(importance->GetDimensions()[k], k < 2 ? 128 : 2);
  }
  double collected[2] = {}, inAll[2] = {}, worst = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int line = 0; line < 128; ++line)
    {
      double used = 0;
      for (int i = 0; i < 128; ++i)
      {
        const auto* value = static_cast<float*>(importance->GetScalarPointer(i, line, axis));
        collected[axis] += value[0];
        used += value[1];
      }
      inAll[axis] += used;
      for (int i = 0; i < 128; ++i)
      {
        const auto* value = static_cast<float*>(importance->GetScalarPointer(i, line, axis));
        const auto* from = static_cast<float*>(functions->GetScalarPointer(i, line, axis));
        const auto* to = static_cast<float*>(functions->GetScalarPointer(i + 1, line, axis));
        worst = std::max(worst, std::abs(*to - *from - value[1] / used));
      }
    }
  }
  std::cout << "importance: " << collected[0] << " and " << collected[1] << " samples, used "
            << inAll[0] << " and " << inAll[1] << ", steps differ by " << worst << std::endl;
  RTW_CHECK(collected[0] > 5000);
  RTW_CHECK_NEAR(collected[1] / collected[0], 1, 1e-3);
  RTW_CHECK(worst < 1e-5);
  // Neither smoothing nor blurring makes it more or less, but for what falls beside the focus.
  for (int axis = 0; axis < 2; ++axis)
  {
    RTW_CHECK_NEAR(inAll[axis] / collected[axis], 1, 0.015);
  }
}

// By the twin in double, from what was collected. How much smoothing was chosen along both axes.
double TestAutomaticSmoothing(int weights, int rasterization)
{
  constexpr int cells = 128;
  constexpr unsigned int resolution = 256;
  rtwShadowStage stage(rtwTechnique::NoTW);
  stage.Name = "automatic";
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  WarpOf(stage)->SetWeights(weights);
  WarpOf(stage)->SetImportanceResolution(cells);
  stage.Pass->SetRasterization(rasterization);
  stage.Pass->SetMaximumEdgeLength(0.04);
  stage.Pass->SetResolution(resolution);
  stage.Render();
  const bool root = weights == vtkNonOrthogonalShadowMapWarp::SQRT_DEMAND;
  const double straight = rasterization == vtkAdaptiveShadowMapPass::LINEAR ? 0.25
    : rasterization == vtkAdaptiveShadowMapPass::TESSELLATED                ? 0.04
                                                                            : 0;
  const vtkSmartPointer<vtkImageData> importance = stage.Pass->GetImportanceImage(0);
  const vtkSmartPointer<vtkImageData> functions = stage.Pass->GetWarpImage(0);
  double all = 0, worst = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    std::vector<std::vector<double>> asked(cells, std::vector<double>(cells));
    for (int line = 0; line < cells; ++line)
    {
      for (int i = 0; i < cells; ++i)
      {
        const double value = *static_cast<float*>(importance->GetScalarPointer(i, line, axis));
        asked[line][i] = root ? value * value : value;
      }
    }
    const double smoothing = rtw::WarpingGrid::ChooseSmoothing(
      asked, root, 0.01, rtw::SmoothingChoice::BendCost(straight, resolution));
    all += smoothing;
    const rtw::WarpingGrid grid =
      rtw::WarpingGrid::FromImportance(asked, smoothing * cells, root, 2, 0.01);
    for (int line = 0; line < cells; ++line)
    {
      for (int i = 0; i < cells; ++i)
      {
        const double value = *static_cast<float*>(functions->GetScalarPointer(i, line, axis));
        worst = std::max(worst, std::abs(value - grid.GetLines()[line].GetValues()[i]));
      }
    }
  }
  std::cout << "automatic: weights " << weights << ", rasterization " << rasterization
            << ": smoothing " << 0.5 * all << ", functions differ by " << worst << std::endl;
  // Running sums of floats leave what is small beside what they had; its root is less small.
  RTW_CHECK(worst < (root ? 3e-3 : 1e-4));
  return all;
}

void TestAutomaticSmoothing()
{
  const int demand = vtkNonOrthogonalShadowMapWarp::SQRT_DEMAND;
  TestAutomaticSmoothing(vtkNonOrthogonalShadowMapWarp::COUNT, vtkAdaptiveShadowMapPass::AUTOMATIC);
  const double exact = TestAutomaticSmoothing(demand, vtkAdaptiveShadowMapPass::EXACT);
  const double pieces = TestAutomaticSmoothing(demand, vtkAdaptiveShadowMapPass::TESSELLATED);
  const double straight = TestAutomaticSmoothing(demand, vtkAdaptiveShadowMapPass::LINEAR);
  RTW_CHECK(exact < pieces && pieces < straight);
}

void TestSettings()
{
  rtwShadowStage stage(rtwTechnique::NoTW);
  stage.Name = "settings";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNonOrthogonalShadowMapWarp* warp = WarpOf(stage);
  double before = 1;
  for (const double smoothing : { 0.01, 0.05, 0.3 })
  {
    warp->AutomaticSmoothingOff();
    warp->SetSmoothing(smoothing);
    warp->SetImportanceResolution(256);
    stage.Render();
    const double step = LargestStep(stage, 256);
    std::cout << "smoothing " << smoothing << ": neighbours differ by " << step << std::endl;
    RTW_CHECK(step < before);
    before = step;
    RTW_CHECK_SHADOWS(stage, sun, 0);
  }
  warp->SetWeightsToCount();
  warp->SetImportanceResolution(90); // no power of two
  stage.Pass->SetResolution(1000);
  stage.Render();
  LargestStep(stage, 90);
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestBadInput()
{
  rtwShadowStage stage(rtwTechnique::NoTW);
  stage.Name = "bad input";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNonOrthogonalShadowMapWarp* warp = WarpOf(stage);
  rtwMessageCatcher messages(warp);
  const double smoothing = warp->GetSmoothing();
  warp->SetWeights(7);
  warp->SetSmoothing(std::numeric_limits<double>::quiet_NaN());
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 2);
  RTW_CHECK_EQUAL(warp->GetWeights(), vtkNonOrthogonalShadowMapWarp::SQRT_DEMAND);
  RTW_CHECK_EQUAL(warp->GetSmoothing(), smoothing);
  warp->SetSmoothing(-1);
  RTW_CHECK_EQUAL(warp->GetSmoothing(), 0.0);
  warp->SetSmoothing(7);
  RTW_CHECK_EQUAL(warp->GetSmoothing(), 1.0);
  warp->SetImportanceResolution(1);
  RTW_CHECK_EQUAL(warp->GetImportanceResolution(), 64);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK(stage.Pass->GetWarpImage(1) == nullptr);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 2);
}
}

int TestNoTW(int, char*[])
{
  TestRasterization();
  TestMaps();
  TestImportance();
  TestAutomaticSmoothing();
  TestSettings();
  TestBadInput();
  return rtwTestResult();
}
