// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMeshBuilder.h"
#include "rtwScene.h"

#include <vtkPolyData.h>

namespace rtw
{
Scene MakeFloor()
{
  constexpr double half = 150;
  MeshBuilder mesh;
  mesh.Ground(-half, half, -half, half, 1);
  for (int i = 0; i < 12; ++i)
  {
    mesh.Box({ 4.0 * (i % 3) - 5.0, 1, 2.0 - 9.0 * i }, dvec3(2));
  }
  // A roof, large and bent too, over a part of them.
  mesh.Add(
    { { 4, 3, -80 }, { 30, 3, -80 }, { 30, 3, 0 }, { 4, 3, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  Scene scene;
  scene.Name = "floor";
  scene.Mesh = mesh.Build();
  scene.Camera = { { 0, 2.2, 12 }, { 0, 1.5, 0 }, { 0, 1, 0 }, 30, .5, 400 };
  scene.Path = { { { 1.5, 2.6, 13 }, { .5, 1.4, 0 } }, { { -1, 3, 14 }, { -.5, 1.5, 0 } } };
  scene.Light.Direction = Unit({ -3, -4, -2 });
  return scene;
}
}
