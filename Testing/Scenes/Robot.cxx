// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"

#include <vtkPolyData.h>

namespace rtw
{
namespace
{
// With pilasters, bolts and cables.
void AddWall(MeshBuilder& mesh)
{
  mesh.Ground(-30, 30, -30, 30, 12);
  mesh.Grid([](double u, double v) { return dvec3(-30 + 60 * u, 8 * v, -1); }, 12, 6);
  for (const double x : Arange(-8, 9, 1.6))
  {
    mesh.Box({ x, 2.2, -.98 }, { .12, 4.4, .08 });
    for (const double y : Arange(.3, 4.2, .3))
    {
      mesh.Tube({ x + .5, y, -1 }, { x + .5, y, -.90 }, .04, 10);
    }
  }
  for (const double y : { 1.1, 2.4, 3.6 })
  {
    mesh.Tube({ -9, y, -.93 }, { 9, y, -.93 }, .03, 10, 20);
  }
}

void AddLimbs(MeshBuilder& mesh, double side)
{
  mesh.Sphere({ side * .75, 2.5, .2 }, .2, 14);
  mesh.Tube({ side * .75, 2.5, .2 }, { side * 1.25, 1.8, .5 }, .13, 16, 3);
  mesh.Tube({ side * 1.25, 1.8, .5 }, { side * 1.1, 1.3, 1.1 }, .1, 16, 3);
  for (int finger = 0; finger < 3; ++finger)
  {
    mesh.Tube({ side * 1.1, 1.3, 1.1 }, { side * 1.1 + .08 * (finger - 1), 1.15, 1.35 }, .025, 8);
  }
  mesh.Tube({ side * .32, 1.4, .2 }, { side * .38, .2, .2 }, .17, 16, 4);
  mesh.Box({ side * .38, .1, .3 }, { .4, .2, .7 });
}

void AddRobot(MeshBuilder& mesh)
{
  mesh.Box({ 0, 2.0, .2 }, { 1.1, 1.3, .7 });
  mesh.Box({ 0, 3.05, .2 }, { .7, .6, .6 });
  mesh.Sphere({ -.17, 3.1, .52 }, .09, 12);
  mesh.Sphere({ .17, 3.1, .52 }, .09, 12);
  mesh.Tube({ 0, 3.35, .2 }, { 0, 3.9, .2 }, .02, 8);
  mesh.Sphere({ 0, 3.95, .2 }, .07, 10);
  AddLimbs(mesh, -1);
  AddLimbs(mesh, 1);
  for (int k = 0; k < 9; ++k)
  {
    mesh.Torus({ 0, 1.35 + .02 * k, .2 }, .5 - .01 * k, .012, 40, 8);
  }
}

void AddRailing(MeshBuilder& mesh)
{
  for (int k = 0; k < 30; ++k)
  {
    mesh.Tube({ -6 + .4 * k, 0, 1.9 }, { -6 + .4 * k, .8, 1.9 }, .015, 8);
  }
  mesh.Tube({ -6, .8, 1.9 }, { 5.6, .8, 1.9 }, .025, 8);
}
}

Scene MakeRobot(double)
{
  MeshBuilder mesh;
  AddWall(mesh);
  AddRobot(mesh);
  AddRailing(mesh);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 2.3, 2.4, 7.2 }, { -.4, 1.7, -.6 }, { 0, 1, 0 }, 42, .5, 60 };
  scene.Light.Direction = Unit({ -.80, -.55, -.07 });
  return scene;
}
}
