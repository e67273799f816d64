// SPDX-License-Identifier: BSD-3-Clause
// What each importance function does to the warping maps: the user's own, written as one of them,
// does the same.
#include "rtwImportanceScene.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <cmath>

namespace
{
using Pass = vtkRTWShadowMapPass;
using Maps = rtwImportanceScene::Maps;
using Point = std::array<double, 3>;

// The user's own function, written as a published one, gives the same maps.
void TestUserFunction()
{
  rtwImportanceScene scene;
  scene.AddSun(4, 5, 1);
  const Maps view = scene.MapsWith(Pass::DESIRED_VIEW);
  const Maps distance = scene.MapsWith(Pass::DISTANCE_TO_EYE);
  rtwCheckApart("distance to eye", distance, view);
  rtwCheckAlike("distance of the user's own", scene.MapsOf("1.0 / depth"), distance);
  rtwCheckAlike("the same with the position", scene.MapsOf("-1.0 / position.z"), distance);
  rtwCheckAlike("a function of one", scene.MapsOf("1"), view);
  rtwCheckAlike("none", scene.MapsOf(""), view);
  rtwCheckAlike("times another", scene.MapsOf("1 / depth", Pass::DISTANCE_TO_EYE),
    scene.MapsOf("float d = depth;\nreturn 1.0 / (d * d);"));
  const Maps normal = scene.MapsWith(Pass::SURFACE_NORMAL);
  rtwCheckApart("surface normal", normal, view, 1e-3);
  rtwCheckAlike(
    "normal of the user's own", scene.MapsOf("1.0 + 2.0 * clamp(normal.z, 0.0, 1.0)"), normal);
  scene.Warped->SetSurfaceNormalBonus(0);
  rtwCheckAlike("no bonus", scene.MapsWith(Pass::SURFACE_NORMAL), view);
  // The sun's direction in view coordinates, for a product that is luminance.
  const vtkMatrix4x4* toView = scene.Renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  std::string sun = "vec3(";
  for (int row = 0; row < 3; ++row)
  {
    const double component =
      4 * toView->GetElement(row, 0) + 5 * toView->GetElement(row, 1) + toView->GetElement(row, 2);
    sun += std::to_string(component) + (row < 2 ? ", " : ")");
  }
  const Maps lit = scene.MapsOf("luminance * luminance * luminance");
  rtwCheckApart("luminance", lit, view, 1e-3);
  rtwCheckAlike("luminance of the user's own",
    scene.MapsOf("pow(dot(normal, normalize(" + sun + ")), 3.0)"), lit, 1e-4);
}

void TestInterest()
{
  rtwImportanceScene scene(false);
  scene.AddSun(0, 10, 0);
  const Maps view = scene.MapsWith(Pass::DESIRED_VIEW);
  const Point middle = { -0.09, 0, -0.82 }, side = { 3, 0, 2 }, corner = { -5, 0, -4 };
  scene.Warped->SetInterestViewRadius(0.2);
  const Maps centre = scene.MapsWith(Pass::CENTRE_OF_INTEREST);
  for (int axis = 0; axis < 2; ++axis)
  {
    RTW_CHECK(scene.DensityAt(middle, axis, centre) > 3 * scene.DensityAt(corner, axis, centre));
    RTW_CHECK(scene.DensityAt(middle, axis, view) < 1.5 * scene.DensityAt(corner, axis, view));
  }
  scene.Warped->SetInterestToSphere();
  scene.Warped->SetInterestCentre(side.data());
  scene.Warped->SetInterestRadius(0.75);
  const Maps sphere = scene.MapsWith(Pass::CENTRE_OF_INTEREST);
  for (int axis = 0; axis < 2; ++axis)
  {
    RTW_CHECK(scene.DensityAt(side, axis, sphere) > 3 * scene.DensityAt(middle, axis, sphere));
    RTW_CHECK_NEAR(
      scene.DensityAt(corner, axis, sphere), scene.DensityAt(middle, axis, sphere), 0.02);
  }
  double at[4] = { side[0], side[1], side[2], 1 };
  scene.Renderer->GetActiveCamera()->GetModelViewTransformMatrix()->MultiplyPoint(at, at);
  const std::string inView = "vec3(" + std::to_string(at[0]) + "," + std::to_string(at[1]) + "," +
    std::to_string(at[2]) + ")";
  rtwCheckAlike("sphere of the user's own",
    scene.MapsOf(
      "1.0 + 4.0 * (1.0 - smoothstep(1.0, 2.0, distance(position, " + inView + ") / 0.75))"),
    sphere);
  scene.Warped->SetInterestBonus(0);
  rtwCheckAlike("no interest", scene.MapsWith(Pass::CENTRE_OF_INTEREST), view);
}

// Camera and sun straight above: there a pixel's footprint is a box.
void TestFootprints()
{
  rtwImportanceScene scene(false);
  scene.AddFloor(1.5)->SetPosition(-2, 1.5, 1);
  scene.AddSun(0, 10, 0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0, 9, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, -1);
  scene.Warped->SetBlurSigma(0);
  const Maps footprint = scene.MapsWith(Pass::FOOTPRINT);
  rtwCheckApart("footprint", footprint, scene.MapsWith(Pass::DESIRED_VIEW));
  rtwCheckAlike("footprint of the user's own",
    scene.MapsOf("inversesqrt(footprint.x * footprint.y)"), footprint);
  // Demand times the footprint is the number of samples, under a root.
  const Maps count = scene.MapsWith(Pass::SAMPLE_COUNT);
  const Maps root = scene.MapsOf("256.0 * footprint.x", Pass::SQRT_DEMAND);
  rtwCheckApart("sample count", count, root, 1e-3);
  std::vector<double> squares(1, 0.0);
  for (std::size_t i = 1; i < root[0].size(); ++i)
  {
    squares.push_back(squares.back() + std::pow(root[0][i] - root[0][i - 1], 2.0));
  }
  for (double& value : squares)
  {
    value /= squares.back();
  }
  rtwCheckAlike("sample count by demand", { squares, count[1] }, count, 2e-3);
}
}

int TestImportanceFunctions(int, char*[])
{
  TestUserFunction();
  TestInterest();
  TestFootprints();
  return rtwTestResult();
}
