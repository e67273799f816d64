// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

#include <cmath>

namespace rtw
{
namespace
{
const double PI = std::acos(-1.0);

void AddPit(MeshBuilder& mesh, Random& random)
{
  double bumps[6][4];
  for (auto& bump : bumps)
  {
    for (double& value : bump)
    {
      value = random.Normal();
    }
  }
  const auto sand = [&bumps](double u, double v) {
    double sum = 0;
    for (const auto& b : bumps)
    {
      sum += std::sin(b[0]) * std::sin((2 + std::abs(b[1])) * 7 * u + b[2]) *
        std::cos((2 + std::abs(b[3])) * 6 * v + b[1]);
    }
    return dvec3(-3 + 6 * u, .04 * sum, -3 + 6 * v);
  };
  mesh.Grid(sand, 64, 64);
  mesh.Ground(-40, 40, -40, 40, 20, -.3);
  mesh.Box({ -3.1, .02, 0 }, { .2, .5, 6.4 });
  mesh.Box({ 3.1, .02, 0 }, { .2, .5, 6.4 });
  mesh.Box({ 0, .02, -3.1 }, { 6, .5, .2 });
  mesh.Box({ 0, .02, 3.1 }, { 6, .5, .2 });
}

void AddBucketAndBalls(MeshBuilder& mesh)
{
  mesh.Sphere({ -1.4, .45, .6 }, .45, 20);
  mesh.Torus({ .7, .18, 1.2 }, .45, .13, 40, 16);
  mesh.Torus({ 1.9, .5, -.4 }, .45, .1, 32, 12, { Axis::Z, 1, .6 });
  mesh.Cone({ 1.2, 0, -1.5 }, { 1.2, .8, -1.5 }, .4, .5, 32, 2);
  mesh.Torus({ 1.2, .8, -1.5 }, .5, .5 * .04, 32, 8);
  mesh.Torus({ 1.2, .8, -1.5 }, .5, .02, 24, 6, { Axis::Z, .5, 0 });
}

void AddRakeAndSieve(MeshBuilder& mesh)
{
  for (int k = 0; k < 14; ++k)
  {
    const double x = -.8 + .06 * k;
    mesh.Tube({ x, .35, 2.0 }, { x, .02, 2.08 }, .009, 6);
  }
  mesh.Box({ -.41, .36, 2.0 }, { .86, .03, .04 });
  mesh.Tube({ -.41, .36, 2.0 }, { -.3, 1.5, .9 }, .025, 10, 4);
  for (int k = 0; k < 23; ++k) // a fine grid
  {
    mesh.Box({ -1.5 + .05 * k, .75, -1.4 }, { .010, .010, 1.1 });
    mesh.Box({ -.95, .762, -1.95 + .05 * k }, { 1.1, .010, .010 });
  }
  for (const double z : { -1.95, -.85 })
  {
    for (const double x : { -1.5, -.4 })
    {
      mesh.Tube({ x, 0, z }, { x, .76, z }, .025, 8);
    }
  }
}

void AddPebblesAndSticks(MeshBuilder& mesh, Random& random)
{
  for (int k = 0; k < 40; ++k)
  {
    const double px = random.Uniform(-2.7, 2.7), pz = random.Uniform(-2.7, 2.7);
    mesh.Sphere({ px, .05, pz }, random.Uniform(.02, .06), 6);
    const double qx = random.Uniform(-2.7, 2.7), qz = random.Uniform(-2.7, 2.7);
    const double topX = qx + random.Uniform(-.3, .3), topY = random.Uniform(.2, .7);
    const double topZ = qz + random.Uniform(-.3, .3);
    mesh.Cone({ qx, 0, qz }, { topX, topY, topZ }, .012, .004, 6, 1);
  }
}

void AddCastle(MeshBuilder& mesh)
{
  for (int k = 0; k < 8; ++k)
  {
    const double a = 2 * PI * k / 8;
    const double x = .1 + .5 * std::cos(a), z = -.2 + .5 * std::sin(a);
    mesh.Cone({ x, 0, z }, { x, .6, z }, .11, .09, 16, 3);
    mesh.Cone({ x, .6, z }, { x, .85, z }, .13, .001, 16, 2);
  }
}

void AddLadder(MeshBuilder& mesh)
{
  mesh.Tube({ 0, 0, -2.4 }, { 0, 2.2, -2.4 }, .03, 8, 2);
  mesh.Tube({ .5, 0, -2.4 }, { .5, 2.2, -2.4 }, .03, 8, 2);
  for (int k = 0; k < 18; ++k)
  {
    const double y = .1 + .12 * k;
    mesh.Tube({ 0, y, -2.4 }, { .5, y, -2.4 }, .012, 6);
  }
}

// As many as make the scene the size it has.
void AddBricks(MeshBuilder& mesh, Random& random)
{
  while (mesh.NumberOfTriangles() < 29040)
  {
    const double x = random.Uniform(-2.8, 2.8), z = random.Uniform(-2.8, 2.8);
    dvec3 size;
    for (int i = 0; i < 3; ++i)
    {
      size[i] = random.Uniform(.02, .12);
    }
    const double turn = random.Uniform(0, 3);
    mesh.Box({ x, .06, z }, size, turn, random.Uniform(0, 3));
  }
}
}

Scene MakeSandbox(double)
{
  Random random(2);
  MeshBuilder mesh;
  AddPit(mesh, random);
  AddBucketAndBalls(mesh);
  AddRakeAndSieve(mesh);
  AddPebblesAndSticks(mesh, random);
  AddCastle(mesh);
  AddLadder(mesh);
  AddBricks(mesh, random);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 3.9, 2.5, 4.3 }, { 0, .2, -.1 }, { 0, 1, 0 }, 40, .5, 60 };
  const dvec3 position(-5.5, 6.5, 3.2);
  scene.Light = { true, position, Unit(dvec3(.2, 0, -.2) - position), 28 };
  return scene;
}
}
