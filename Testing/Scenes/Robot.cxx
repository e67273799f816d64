// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"

#include <vtkPolyData.h>

namespace rtw
{
namespace
{
// With pilasters, bolts and cables. More bolts are thinner ones.
void AddWall(MeshBuilder& mesh, double root)
{
  mesh.Ground(-30, 30, -30, 30, Finer(12, root, 2));
  mesh.Grid([](double u, double v) { return dvec3(-30 + 60 * u, 8 * v, -1); }, Finer(12, root, 2),
    Finer(6, root, 1));
  for (const double x : Arange(-8, 9, 1.6))
  {
    mesh.Box({ x, 2.2, -.98 }, { .12, 4.4, .08 });
    for (const double y : Arange(.3, 4.2, .3 / root))
    {
      mesh.Tube({ x + .5, y, -1 }, { x + .5, y, -.90 }, .04 / std::max(1.0, root), 10);
    }
  }
  for (const double y : { 1.1, 2.4, 3.6 })
  {
    mesh.Tube({ -9, y, -.93 }, { 9, y, -.93 }, .03, Finer(10, root, 4), Finer(20, root, 2));
  }
}

void AddLimbs(MeshBuilder& mesh, double side, double root)
{
  const int sides = Finer(16, root, 5);
  mesh.Sphere({ side * .75, 2.5, .2 }, .2, Finer(14, root, 4));
  mesh.Tube({ side * .75, 2.5, .2 }, { side * 1.25, 1.8, .5 }, .13, sides, Finer(3, root, 1));
  mesh.Tube({ side * 1.25, 1.8, .5 }, { side * 1.1, 1.3, 1.1 }, .1, sides, Finer(3, root, 1));
  for (int finger = 0; finger < 3; ++finger)
  {
    mesh.Tube({ side * 1.1, 1.3, 1.1 }, { side * 1.1 + .08 * (finger - 1), 1.15, 1.35 }, .025,
      Finer(8, root, 4), Finer(1, root, 1));
  }
  mesh.Tube({ side * .32, 1.4, .2 }, { side * .38, .2, .2 }, .17, sides, Finer(4, root, 1));
  mesh.Box({ side * .38, .1, .3 }, { .4, .2, .7 });
}

void AddRobot(MeshBuilder& mesh, double root)
{
  mesh.Box({ 0, 2.0, .2 }, { 1.1, 1.3, .7 });
  mesh.Box({ 0, 3.05, .2 }, { .7, .6, .6 });
  mesh.Sphere({ -.17, 3.1, .52 }, .09, Finer(12, root, 3));
  mesh.Sphere({ .17, 3.1, .52 }, .09, Finer(12, root, 3));
  mesh.Tube({ 0, 3.35, .2 }, { 0, 3.9, .2 }, .02, Finer(8, root, 4), Finer(1, root, 1));
  mesh.Sphere({ 0, 3.95, .2 }, .07, Finer(10, root, 3));
  AddLimbs(mesh, -1, root);
  AddLimbs(mesh, 1, root);
  for (int k = 0; k < 9; ++k)
  {
    mesh.Torus(
      { 0, 1.35 + .02 * k, .2 }, .5 - .01 * k, .012, Finer(40, root, 8), Finer(8, root, 4));
  }
}

void AddRailing(MeshBuilder& mesh, double root)
{
  for (int k = 0; k < 30; ++k)
  {
    mesh.Tube({ -6 + .4 * k, 0, 1.9 }, { -6 + .4 * k, .8, 1.9 }, .015, Finer(8, root, 4),
      Finer(1, root, 1));
  }
  mesh.Tube({ -6, .8, 1.9 }, { 5.6, .8, 1.9 }, .025, Finer(8, root, 4), Finer(1, root, 1));
}
}

// Few things, all round: they become finer.
Scene MakeRobot(double scale)
{
  const double root = std::sqrt(scale);
  MeshBuilder mesh;
  AddWall(mesh, root);
  AddRobot(mesh, root);
  AddRailing(mesh, root);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 2.3, 2.4, 7.2 }, { -.4, 1.7, -.6 }, { 0, 1, 0 }, 42, .5, 60 };
  scene.Path = { { { 4.4, 1.9, 5.2 }, { -.8, 1.8, -.6 } }, { { 1.2, 3.2, 4.9 }, { -.9, 1.5, -.7 } },
    { { -2.6, 2.0, 5.6 }, { .3, 1.8, -.5 } } };
  scene.LightSwing = -12; // away from the wall, which would lose its light
  scene.Light.Direction = Unit({ -.80, -.55, -.07 });
  return scene;
}
}
