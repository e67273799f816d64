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

void AddPit(MeshBuilder& mesh, Random& random, double root)
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
  mesh.Grid(sand, Finer(64, root, 8), Finer(64, root, 8));
  mesh.Ground(-40, 40, -40, 40, Finer(20, root, 4), -.3);
  mesh.Box({ -3.1, .02, 0 }, { .2, .5, 6.4 });
  mesh.Box({ 3.1, .02, 0 }, { .2, .5, 6.4 });
  mesh.Box({ 0, .02, -3.1 }, { 6, .5, .2 });
  mesh.Box({ 0, .02, 3.1 }, { 6, .5, .2 });
}

void AddBucketAndBalls(MeshBuilder& mesh, double root)
{
  const int ring = Finer(32, root, 8);
  mesh.Sphere({ -1.4, .45, .6 }, .45, Finer(20, root, 5));
  mesh.Torus({ .7, .18, 1.2 }, .45, .13, Finer(40, root, 8), Finer(16, root, 5));
  mesh.Torus({ 1.9, .5, -.4 }, .45, .1, ring, Finer(12, root, 4), { Axis::Z, 1, .6 });
  mesh.Cone({ 1.2, 0, -1.5 }, { 1.2, .8, -1.5 }, .4, .5, ring, Finer(2, root, 1));
  mesh.Torus({ 1.2, .8, -1.5 }, .5, .5 * .04, ring, Finer(8, root, 4));
  mesh.Torus({ 1.2, .8, -1.5 }, .5, .02, Finer(24, root, 6), Finer(6, root, 3), { Axis::Z, .5, 0 });
}

void AddRakeAndSieve(MeshBuilder& mesh, double root)
{
  for (int k = 0; k < 14; ++k)
  {
    const double x = -.8 + .06 * k;
    mesh.Tube({ x, .35, 2.0 }, { x, .02, 2.08 }, .009, Finer(6, root, 4));
  }
  mesh.Box({ -.41, .36, 2.0 }, { .86, .03, .04 });
  mesh.Tube({ -.41, .36, 2.0 }, { -.3, 1.5, .9 }, .025, Finer(10, root, 4), Finer(4, root, 1));
  for (int k = 0; k < 23; ++k) // a fine grid
  {
    mesh.Box({ -1.5 + .05 * k, .75, -1.4 }, { .010, .010, 1.1 });
    mesh.Box({ -.95, .762, -1.95 + .05 * k }, { 1.1, .010, .010 });
  }
  for (const double z : { -1.95, -.85 })
  {
    for (const double x : { -1.5, -.4 })
    {
      mesh.Tube({ x, 0, z }, { x, .76, z }, .025, Finer(8, root, 4));
    }
  }
}

void AddPebblesAndSticks(MeshBuilder& mesh, Random& random, double root)
{
  for (int k = 0; k < 40; ++k)
  {
    const double px = random.Uniform(-2.7, 2.7), pz = random.Uniform(-2.7, 2.7);
    mesh.Sphere({ px, .05, pz }, random.Uniform(.02, .06), Finer(6, root, 3));
    const double qx = random.Uniform(-2.7, 2.7), qz = random.Uniform(-2.7, 2.7);
    const double topX = qx + random.Uniform(-.3, .3), topY = random.Uniform(.2, .7);
    const double topZ = qz + random.Uniform(-.3, .3);
    mesh.Cone({ qx, 0, qz }, { topX, topY, topZ }, .012, .004, Finer(6, root, 3), 1);
  }
}

void AddCastle(MeshBuilder& mesh, double root)
{
  for (int k = 0; k < 8; ++k)
  {
    const double a = 2 * PI * k / 8;
    const double x = .1 + .5 * std::cos(a), z = -.2 + .5 * std::sin(a);
    mesh.Cone({ x, 0, z }, { x, .6, z }, .11, .09, Finer(16, root, 5), Finer(3, root, 1));
    mesh.Cone({ x, .6, z }, { x, .85, z }, .13, .001, Finer(16, root, 5), Finer(2, root, 1));
  }
}

void AddLadder(MeshBuilder& mesh, double root)
{
  const int sides = Finer(8, root, 4);
  mesh.Tube({ 0, 0, -2.4 }, { 0, 2.2, -2.4 }, .03, sides, 2);
  mesh.Tube({ .5, 0, -2.4 }, { .5, 2.2, -2.4 }, .03, sides, 2);
  for (int k = 0; k < 18; ++k)
  {
    const double y = .1 + .12 * k;
    mesh.Tube({ 0, y, -2.4 }, { .5, y, -2.4 }, .012, Finer(6, root, 4));
  }
}

// As many as make the scene the size it has. More bricks are smaller ones, down to gravel, or they
// would bury the toys.
void AddBricks(MeshBuilder& mesh, Random& random, double scale)
{
  const double shrink = 1 / std::max(1.0, std::sqrt(scale));
  while (double(mesh.NumberOfTriangles()) < 29040 * scale)
  {
    const double x = random.Uniform(-2.8, 2.8), z = random.Uniform(-2.8, 2.8);
    dvec3 size;
    for (int i = 0; i < 3; ++i)
    {
      size[i] = random.Uniform(.02, .12);
    }
    const double turn = random.Uniform(0, 3);
    mesh.Box({ x, .06, z }, size * shrink, turn, random.Uniform(0, 3));
  }
}
}

// The sand and the toys become finer; bricks fill what is left.
Scene MakeSandbox(double scale)
{
  const double root = std::sqrt(scale);
  Random random(2);
  MeshBuilder mesh;
  AddPit(mesh, random, root);
  AddBucketAndBalls(mesh, root);
  AddRakeAndSieve(mesh, root);
  AddPebblesAndSticks(mesh, random, root);
  AddCastle(mesh, root);
  AddLadder(mesh, root);
  AddBricks(mesh, random, scale);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 3.9, 2.5, 4.3 }, { 0, .2, -.1 }, { 0, 1, 0 }, 40, .5, 60 };
  scene.Path = { { { 4.6, 1.8, 2.4 }, { .2, .2, -.3 } }, { { 2.8, 1.4, 4.2 }, { 0, .3, .2 } },
    { { 1.2, 3.0, 5.0 }, { .1, .2, -.2 } } };
  const dvec3 position(-5.5, 6.5, 3.2);
  scene.Light = { true, position, Unit(dvec3(.2, 0, -.2) - position), 28 };
  return scene;
}
}
