// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

namespace rtw
{
Scene MakeDuel(double)
{
  Random random(5);
  MeshBuilder mesh;
  mesh.Ground(-150, 150, -190, 110, 30);
  for (int k = 0; k < 60; ++k)
  {
    const double z = -2 - 2.6 * k * (1 + .012 * k);
    for (const double x : { -9., -4.5, 4.5, 9. })
    {
      mesh.Tube({ x, 0, z }, { x, 3.4, z }, .18, 16, 4);
      mesh.Box({ x, 3.5, z }, { .6, .2, .6 });
    }
    mesh.Box({ 0, 3.75, z }, { 18.6, .12, .12 });
    for (const double x : Linspace(-8.6, 8.6, 39)) // balustrade
    {
      mesh.Box({ x, .45, z }, { .025, .9, .025 });
    }
    mesh.Box({ 0, .92, z }, { 17.6, .05, .05 });
    const double x = random.Uniform(-3.5, 3.5);
    mesh.Sphere({ x, .5, z - 1.2 }, random.Uniform(.2, .45), 12);
  }

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 1.1, 2.3, 4 }, { .3, -.4, -12 }, { 0, 1, 0 }, 55, .3, 250 };
  scene.Light.Direction = Unit({ .05, -.22, 1 });
  return scene;
}
}
