// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

namespace rtw
{
// Columns and balls become finer, and the balustrades have more and thinner balusters: rows of more
// columns would be behind the view's far end.
Scene MakeDuel(double scale)
{
  const double root = std::sqrt(scale);
  const int sides = Finer(16, root, 3), rings = Finer(4, root, 1), ball = Finer(12, root, 3);
  const int balusters = Finer(39, root, 3);
  const double width = .025 * 39 / balusters;
  Random random(5);
  MeshBuilder mesh;
  mesh.Ground(-150, 150, -190, 110, Finer(30, root, 4));
  for (int k = 0; k < 60; ++k)
  {
    const double z = -2 - 2.6 * k * (1 + .012 * k);
    for (const double x : { -9., -4.5, 4.5, 9. })
    {
      mesh.Tube({ x, 0, z }, { x, 3.4, z }, .18, sides, rings);
      mesh.Box({ x, 3.5, z }, { .6, .2, .6 });
    }
    mesh.Box({ 0, 3.75, z }, { 18.6, .12, .12 });
    for (const double x : Linspace(-8.6, 8.6, balusters)) // balustrade
    {
      mesh.Box({ x, .45, z }, { width, .9, width });
    }
    mesh.Box({ 0, .92, z }, { 17.6, .05, .05 });
    const double x = random.Uniform(-3.5, 3.5);
    mesh.Sphere({ x, .5, z - 1.2 }, random.Uniform(.2, .45), ball);
  }

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 1.1, 2.3, 4 }, { .3, -.4, -12 }, { 0, 1, 0 }, 55, .3, 250 };
  scene.Path = { { { 2.6, 2.1, .5 }, { .6, .2, -16 } }, { { .6, 1.7, -2.9 }, { -1.2, .6, -18 } },
    { { -2.4, 2.2, .8 }, { -.8, 0, -14 } } };
  scene.Light.Direction = Unit({ .05, -.22, 1 });
  return scene;
}
}
