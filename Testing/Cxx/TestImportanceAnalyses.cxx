// SPDX-License-Identifier: BSD-3-Clause
// What forward, backward and hybrid analysis see, and the shadow edges in it.
#include "rtwImportanceScene.h"

#include "vtkCamera.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"

#include <iostream>

namespace
{
using Pass = vtkRTWShadowMapPass;
using Maps = rtwImportanceScene::Maps;
using Point = std::array<double, 3>;

// Density at a silhouette's shadow and at the floor beside, of a sun from above.
void CheckEdges(
  rtwImportanceScene& scene, const std::string& what, int importance, int analysis, double times)
{
  scene.MapsWith(importance, analysis);
  const Maps maps = scene.MapsWith(importance, analysis); // the second frame knows a mask
  const Point edge = { 2.5, 0, -1.5 }, beside = { -3, 0, 2 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double ratio = scene.DensityAt(edge, axis, maps) / scene.DensityAt(beside, axis, maps);
    std::cout << what << ", axis " << axis << ": " << ratio << " times as dense at an edge"
              << std::endl;
    rtwCheck(ratio >= times, __FILE__, __LINE__, what);
  }
}

void TestEdges()
{
  rtwImportanceScene scene;
  vtkLight* sun = scene.AddSun(0, 10, 0);
  const int published = Pass::DESIRED_VIEW | Pass::SHADOW_EDGE;
  const int demand = Pass::SQRT_DEMAND | Pass::SHADOW_EDGE;
  const Maps first = scene.MapsWith(published);
  rtwCheckAlike("no mask yet", first, scene.MapsWith(Pass::DESIRED_VIEW));
  CheckEdges(scene, "published, forward", published, Pass::FORWARD, 100);
  CheckEdges(scene, "published, backward", published, Pass::BACKWARD, 100);
  CheckEdges(scene, "published, hybrid", published, Pass::HYBRID, 100);
  CheckEdges(scene, "demand, forward", demand, Pass::FORWARD, 2);
  CheckEdges(scene, "demand, backward", demand, Pass::BACKWARD, 2);
  CheckEdges(scene, "demand, hybrid", demand, Pass::HYBRID, 2);
  scene.Name = "edges";
  rtwShadowBounds bounds;
  bounds.Shadowed = 0.5;
  RTW_CHECK_SHADOWS_WITHIN(scene, sun, 0, bounds);
  const Maps fine = scene.MapsWith(demand, Pass::HYBRID);
  scene.Warped->SetLightImageResolution(16);
  rtwCheckApart("a coarse image", scene.MapsWith(demand, Pass::HYBRID), fine);
  scene.Warped->SetEdgeThreshold(0);
  rtwCheckAlike(
    "all is an edge", scene.MapsWith(demand, Pass::HYBRID), scene.MapsWith(Pass::SQRT_DEMAND));
}

// The mask of the last frame is looked at through the last camera.
void TestMovedCamera()
{
  rtwImportanceScene scene;
  scene.AddSun(0, 10, 0);
  const int demand = Pass::SQRT_DEMAND | Pass::SHADOW_EDGE;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  scene.Render();
  // The same picture upside down, so that nothing comes into view.
  camera->Roll(180);
  const Maps moved = scene.MapsWith(demand);
  rtwCheckAlike("after a turn", scene.MapsWith(demand), moved, 0.02);
  rtwCheckApart("all edges", scene.MapsWith(Pass::SQRT_DEMAND), moved, 0.05);
}

// A light has the maps that it has alone, and what only VTK's mappers can draw casts into its image
// too.
void TestLights()
{
  const int demand = Pass::SQRT_DEMAND | Pass::SHADOW_EDGE;
  for (const int analysis : { Pass::FORWARD, Pass::BACKWARD, Pass::HYBRID })
  {
    rtwImportanceScene alone, both;
    alone.AddSpot(3, 7, 2, 40);
    both.AddSun(0, 10, 0);
    both.AddSpot(3, 7, 2, 40);
    alone.MapsWith(demand, analysis);
    both.MapsWith(demand, analysis);
    rtwCheckAlike("the second light, analysis " + std::to_string(analysis),
      both.MapsWith(demand, analysis, 1), alone.MapsWith(demand, analysis), 1e-4);
  }
  rtwImportanceScene clipped(false);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, 0.1, 0);
  plane->SetNormal(0, 1, 0);
  clipped.AddBall(2, 1, -1, 0.5)->GetMapper()->AddClippingPlane(plane);
  clipped.AddSun(0, 10, 0);
  CheckEdges(clipped, "drawn by a mapper", demand, Pass::HYBRID, 2);
}

// Where nothing hides anything from the light, forward and backward analysis see the same.
void TestForward()
{
  rtwImportanceScene scene(false);
  scene.AddSun(2, 10, 1);
  for (const int importance :
    { int(Pass::DESIRED_VIEW), int(Pass::DISTANCE_TO_EYE), int(Pass::SURFACE_NORMAL),
      int(Pass::FOOTPRINT), int(Pass::SAMPLE_COUNT), int(Pass::SQRT_DEMAND) })
  {
    rtwCheckAlike("forward as backward, importance " + std::to_string(importance),
      scene.MapsWith(importance, Pass::FORWARD), scene.MapsWith(importance), 0.02);
  }
}
}

int TestImportanceAnalyses(int, char*[])
{
  TestEdges();
  TestMovedCamera();
  TestLights();
  TestForward();
  return rtwTestResult();
}
