// SPDX-License-Identifier: BSD-3-Clause
// Filtering in the world: penumbras as wide near and far, whatever the map.
#include "rtwShadowProfile.h"

#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"

#include <cmath>
#include <iostream>

namespace
{
const char* NameOf(rtwTechnique technique)
{
  return technique == rtwTechnique::RTW ? "RTW" : "uniform";
}

// A road into the distance, and a wall along its left side that shadows half of it.
void FillRoad(rtwShadowStage& stage)
{
  vtkNew<vtkPlaneSource> road;
  road->SetOrigin(-10, 0, 4);
  road->SetPoint1(10, 0, 4);
  road->SetPoint2(-10, 0, -60);
  stage.Add(road);
  vtkNew<vtkCubeSource> wall;
  wall->SetBounds(-4, -3, 0, 3, -60, 4);
  stage.Add(wall);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(1, 5, 9);
  camera->SetFocalPoint(0, 0, -8);
  stage.Window->SetSize(800, 600);
  stage.Pass->SetResolution(2048);
  stage.Pass->SetFilterToSoft();
}

// Across the edge, at x = 0, in world units.
double WidthAt(rtwShadowStage& stage, double y, double z, const char* what)
{
  const double from[] = { -1.5, y, z }, to[] = { 1.5, y, z };
  const std::vector<double> profile = rtwProfile(stage, from, to, 300);
  const double width = 3 * rtwWidth(profile), middle = 3 * rtwWhere(profile, 0.5) - 1.5;
  std::cout << stage.Name << ", " << what << ": " << width << " wide, around " << middle
            << std::endl;
  RTW_CHECK(rtwIsMonotone(profile));
  RTW_CHECK_NEAR(middle, 0, 0.06);
  return width;
}

// From a tenth to nine tenths of the integral of (1 - |x|) exp(-2 x²), of radius 1.
constexpr double UprightWidth = 0.862;
// The same under light that falls at 45 degrees.
constexpr double SlantedWidth = UprightWidth * 1.414;

void TestSun(rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  FillRoad(stage);
  stage.AddSun(-3, 3, 0);
  for (const double radius : { 0.3, 0.6 })
  {
    stage.Name = std::string(NameOf(technique)) + ", sun, " + std::to_string(radius);
    stage.Pass->SetFilterRadius(radius);
    stage.Render();
    const double near = WidthAt(stage, 0, -1, "near"), far = WidthAt(stage, 0, -14, "far");
    RTW_CHECK_NEAR(near, SlantedWidth * radius, 0.1 * near);
    RTW_CHECK_NEAR(far, near, 0.1 * near);
  }
}

// A spot's light spreads, the penumbra doesn't: under it two floors, one half as far, and the edge
// of a lid.
void TestSpot(rtwTechnique technique)
{
  rtwShadowStage stage(technique);
  stage.AddFloor();
  vtkNew<vtkCubeSource> upperFloor, lid;
  upperFloor->SetBounds(-3, 3, 0, 3, 0.2, 4);
  lid->SetBounds(-3, 0, 5, 5.2, -3, 3);
  stage.Add(upperFloor);
  stage.Add(lid);
  stage.AddSpot(0, 8, 0, 40);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(7, 7, 0);
  camera->SetFocalPoint(0, 1, 0);
  stage.Window->SetSize(800, 600);
  stage.Pass->SetFilterToSoft();
  stage.Pass->SetFilterRadius(0.4);
  stage.Name = std::string(NameOf(technique)) + ", spot";
  stage.Render();
  for (const bool upper : { false, true })
  {
    const double width = WidthAt(stage, upper ? 3 : 0, upper ? 1.5 : -1.5, upper ? "near" : "far");
    RTW_CHECK_NEAR(width, UprightWidth * 0.4, 0.1 * width);
  }
}

// What is just outside the picture softens what is at its rim: the same pixels, in a larger window.
void TestRim(rtwTechnique technique)
{
  double left[2];
  for (const bool wide : { false, true })
  {
    rtwShadowStage stage(technique);
    stage.AddFloor();
    stage.AddBox(0, 2.5, 0, 1);
    stage.AddSun(0.001, 5, 0);
    stage.Pass->SetFilterToSoft();
    stage.Pass->SetFilterRadius(0.5);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(wide ? 3 : 1.5);
    camera->SetPosition(1.9, 8, 8);
    camera->SetFocalPoint(1.9, 0, 0);
    stage.Window->SetSize(wide ? 400 : 200, wide ? 400 : 200);
    stage.Render();
    const std::vector<unsigned char> mask = stage.GetMask(0);
    left[wide] = rtwVisibilityOf(wide ? mask[200 * 400 + 101] : mask[100 * 200 + 1]);
  }
  std::cout << NameOf(technique) << ", at the rim " << left[0] << ", within " << left[1]
            << std::endl;
  RTW_CHECK(left[1] > 0.2 && left[1] < 0.95);
  RTW_CHECK_NEAR(left[0], left[1], 0.04);
}

// Wider than everything, or too narrow to matter: a picture all the same.
void TestExtremes()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Pass->SetFilterToSoft();
  for (const double radius : { 1e-20, 1e-6 })
  {
    stage.Name = "SOFT of " + std::to_string(radius);
    stage.Pass->SetFilterRadius(radius);
    stage.Render();
    RTW_CHECK_SHADOWS(stage, sun, 0);
  }
  for (const double radius : { 100.0, 1e30 })
  {
    stage.Pass->SetFilterRadius(radius);
    stage.Render();
    const double mean = rtwMeanVisibility(stage.GetMask(0));
    RTW_CHECK(mean > 0.5 && mean < 0.999);
  }
}
}

int TestShadowSoft(int argc, char* argv[])
{
  {
    rtwShadowStage stage;
    stage.AddObjects();
    stage.AddSun(3, 5, 2);
    stage.Pass->SetFilterToSoft();
    stage.Pass->SetFilterRadius(0.3);
    stage.Render();
    rtwCompareWithBaseline(stage.Window, argc, argv);
  }
  for (const rtwTechnique technique : { rtwTechnique::Uniform, rtwTechnique::RTW })
  {
    TestSun(technique);
    TestSpot(technique);
    TestRim(technique);
  }
  TestExtremes();
  return rtwTestResult();
}
