// SPDX-License-Identifier: BSD-3-Clause
// The warping maps that the GPU makes, and what is drawn through them, against their
// double-precision twin.
#include "rtwShadowStage.h"

#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkRTWShadowMapPass.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// Row 0 is along s, row 1 along t.
rtw::WarpingFunction TwinOf(vtkImageData* table, int axis)
{
  const int count = table->GetDimensions()[0];
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(*static_cast<float*>(table->GetScalarPointer(i, axis, 0)));
  }
  return rtw::WarpingFunction::FromValues(values);
}

// Rises from 0 to 1, and no cell gets less than the floor of importance leaves it.
void CheckTable(rtwShadowStage& stage, int light, double least, double most = 1e9)
{
  const vtkSmartPointer<vtkImageData> table = stage.Pass->GetWarpImage(light);
  if (!RTW_CHECK(table != nullptr))
  {
    return;
  }
  auto* pass = vtkRTWShadowMapPass::SafeDownCast(stage.Pass);
  RTW_CHECK_EQUAL(table->GetDimensions()[0], pass->GetImportanceResolution() + 1);
  RTW_CHECK_EQUAL(table->GetDimensions()[1], 2);
  for (int axis = 0; axis < 2; ++axis)
  {
    const rtw::WarpingFunction twin = TwinOf(table, axis);
    RTW_CHECK_EQUAL(twin.GetValues().front(), 0.0);
    RTW_CHECK_NEAR(twin.GetValues().back(), 1.0, 1e-6);
    double lowest = 1e9;
    for (int cell = 0; cell < twin.GetCells(); ++cell)
    {
      lowest = std::min(lowest, twin.Slope(cell));
    }
    std::cout << stage.Name << ", light " << light << ", axis " << axis << ": slopes " << lowest
              << " to " << twin.GreatestSlope() << std::endl;
    RTW_CHECK(lowest >= least);
    RTW_CHECK(twin.GreatestSlope() <= most);
    double worst = 0;
    for (int i = -100; i <= 1100; ++i)
    {
      const double x = i / 1000.0;
      worst = std::max(worst, std::abs(twin.Inverse(twin.Forward(x)) - x));
      worst = std::max(worst, std::abs(twin.Forward(twin.Inverse(x)) - x));
    }
    RTW_CHECK_NEAR(worst, 0, 1e-12);
  }
}

void TestTables()
{
  rtwShadowStage stage;
  stage.Name = "tables";
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  stage.AddSpot(3, 7, 2, 40);
  auto* pass = vtkRTWShadowMapPass::SafeDownCast(stage.Pass);
  stage.Render();
  // The floor is a share of the mean before it raises the mean itself, by no more than that share.
  CheckTable(stage, 0, 0.01 / 1.01 - 1e-3);
  CheckTable(stage, 1, 0.01 / 1.01 - 1e-3);
  for (const int functions : { 1, 3, 7, 8 })
  {
    for (const int cells : { 16, 100, 2048 })
    {
      stage.Name =
        "importance " + std::to_string(functions) + ", " + std::to_string(cells) + " cells";
      pass->SetImportance(functions);
      pass->SetImportanceResolution(cells);
      pass->SetImportanceFloor(0.05);
      stage.Render();
      // Differences of floats over a 2048th.
      CheckTable(stage, 0, 0.05 / 1.05 - 1e-3);
    }
  }
  stage.Name = "highest floor";
  pass->SetImportanceFloor(1);
  pass->SetBlurSigma(0);
  stage.Render();
  // What lies above the mean stays there, so that the sum at most doubles.
  CheckTable(stage, 0, 0.5 - 1e-3);
}

// The edges of a box, seen by a light from above, lie on the map where the twin says.
void TestEdges()
{
  rtwShadowStage stage;
  stage.Name = "edges";
  stage.AddFloor(12);
  stage.AddBox(1.8, 0.6, -0.5, 1.2);
  stage.AddSun(0, 10, 0);
  auto* pass = vtkRTWShadowMapPass::SafeDownCast(stage.Pass);
  pass->FocusOnViewOff();
  stage.Render();
  const vtkSmartPointer<vtkImageData> map = pass->GetShadowMapImage(0);
  const vtkSmartPointer<vtkImageData> table = pass->GetWarpImage(0);
  const int size = map->GetDimensions()[0];
  RTW_CHECK_EQUAL(size, 1024);
  int low[2] = { size, size }, high[2] = { -1, -1 };
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      // The box's top is at the near end of the scene, the floor at the far.
      if (*static_cast<float*>(map->GetScalarPointer(x, y, 0)) < 0.5f)
      {
        low[0] = std::min(low[0], x);
        high[0] = std::max(high[0], x + 1);
        low[1] = std::min(low[1], y);
        high[1] = std::max(high[1], y + 1);
      }
    }
  }
  // s goes along -z and t along x; the square about the floor is a ten-thousandth larger than it.
  const double side = 12 * 1.0001;
  const double edges[2][2] = { { -0.1, 1.1 }, { 1.2, 2.4 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    const rtw::WarpingFunction twin = TwinOf(table, axis);
    const double from = size * twin.Forward(0.5 + edges[axis][0] / side);
    const double to = size * twin.Forward(0.5 + edges[axis][1] / side);
    std::cout << "edges, axis " << axis << ": " << low[axis] << " to " << high[axis]
              << " texels, the twin says " << from << " to " << to << std::endl;
    RTW_CHECK_NEAR(low[axis], from, 0.51);
    RTW_CHECK_NEAR(high[axis], to, 0.51);
    // Over the whole light plane the warp alone makes the map finer than a conventional one.
    RTW_CHECK_NEAR(
      pass->GetMaximumEffectiveResolution(0, axis) / (size * twin.GreatestSlope()), 1, 1e-3);
  }
}

// The side of a focus, on the light plane.
double FocusExtent(vtkAdaptiveShadowMapPass* pass, int light, int axis, const glm::dvec3& direction)
{
  vtkNew<vtkMatrix4x4> matrix;
  RTW_CHECK(pass->GetLightPlaneMatrix(light, 0, matrix));
  const glm::dvec3 row(
    matrix->GetElement(axis, 0), matrix->GetElement(axis, 1), matrix->GetElement(axis, 2));
  return 1 / glm::length(row - glm::dot(row, direction) * direction);
}

// The conventional map over all that a light shines on whose texels are as small as those of the
// largest cell of this one (Rosen 2012, section 6), of focus and warp together.
void TestEffectiveResolution()
{
  rtwShadowStage stage;
  stage.AddObjects();
  stage.AddSun(0, 10, 0);
  stage.AddSpot(0, 8, 0, 40);
  stage.Pass->SetResolution(512);
  stage.Render();
  // As long as the floor, and a ten-thousandth more; a spot's is that of its cone.
  const double sides[2] = { 12 * 1.0001, 2 * std::tan(glm::radians(40.0)) };
  for (int light = 0; light < 2; ++light)
  {
    const vtkSmartPointer<vtkImageData> table = stage.Pass->GetWarpImage(light);
    const glm::dvec3 down(0, -1, 0);
    const rtw::Rectangle focus{ glm::dvec2(0),
      { FocusExtent(stage.Pass, light, 0, down), FocusExtent(stage.Pass, light, 1, down) } };
    const rtw::RectilinearWarp twin{ focus, TwinOf(table, 0), TwinOf(table, 1) };
    const glm::dvec2 expected =
      twin.MaximumEffectiveResolution(512, { glm::dvec2(0), glm::dvec2(sides[light]) });
    for (int axis = 0; axis < 2; ++axis)
    {
      const double actual = stage.Pass->GetMaximumEffectiveResolution(light, axis);
      std::cout << "effective resolution of light " << light << ", axis " << axis << ": " << actual
                << ", the twin says " << expected[axis] << std::endl;
      RTW_CHECK_NEAR(actual / expected[axis], 1, 1e-3);
      RTW_CHECK(actual > 600);
    }
  }
  RTW_CHECK_EQUAL(stage.Pass->GetMaximumEffectiveResolution(0, 2), 0);
  RTW_CHECK_EQUAL(stage.Pass->GetMaximumEffectiveResolution(2, 0), 0);
}
}

int TestShadowWarpTable(int, char*[])
{
  TestTables();
  TestEdges();
  TestEffectiveResolution();
  return rtwTestResult();
}
