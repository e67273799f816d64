// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
const double PI = std::acos(-1.0);

// How finely tubes are tessellated.
struct Fineness
{
  int Sides;
  int Rings;
};

// A dome of meridians and parallels.
void AddDome(MeshBuilder& mesh, const Fineness& fine)
{
  for (int a = 0; a < 12; ++a)
  {
    Points meridian;
    for (const double t : Linspace(0, PI / 2, 4 * fine.Rings - 1))
    {
      meridian.emplace_back(3 * std::cos(t) * std::cos(a * PI / 6) - 4, 3 * std::sin(t) * .9,
        3 * std::cos(t) * std::sin(a * PI / 6));
    }
    mesh.Sweep(meridian, { .035 }, fine.Sides);
  }
  for (const double e : Arange(.15, 1.5, .26))
  {
    mesh.Torus({ -4, 3 * std::sin(e) * .9, 0 }, 3 * std::cos(e), .03, 8 * fine.Rings, fine.Sides);
  }
}

void AddCubeFrame(MeshBuilder& mesh, const Fineness& fine)
{
  const auto bar = [&](const dvec3& from, const dvec3& to) {
    mesh.Tube(from, to, .03, fine.Sides, fine.Rings);
  };
  for (int x = 0; x < 6; ++x)
  {
    for (int y = 0; y < 5; ++y)
    {
      bar({ 2 + .6 * x, .6 * y + .1, -3 }, { 2 + .6 * x, .6 * y + .1, 0 });
    }
  }
  for (int z = 0; z < 6; ++z)
  {
    for (int y = 0; y < 5; ++y)
    {
      bar({ 2, .6 * y + .1, -3 + .6 * z }, { 5, .6 * y + .1, -3 + .6 * z });
    }
    for (int x = 0; x < 6; ++x)
    {
      bar({ 2 + .6 * x, 0, -3 + .6 * z }, { 2 + .6 * x, 2.6, -3 + .6 * z });
    }
  }
}

// Swings on chains of small rings.
void AddSwings(MeshBuilder& mesh, const Fineness& fine)
{
  for (int s = 0; s < 4; ++s)
  {
    const double x = -2 + 1.3 * s;
    for (const double dx : { -.25, .25 })
    {
      for (int c = 0; c < 26; ++c)
      {
        mesh.Torus({ x + dx, .7 + .09 * c, 4.5 + .02 * c * (s - 1.5) }, .045, .011,
          3 * fine.Rings / 2, std::max(3, fine.Sides / 3), { c % 2 ? Axis::X : Axis::Z, 1, 0 });
      }
    }
    mesh.Box({ x, .66, 4.5 }, { .6, .05, .25 });
  }
  mesh.Tube({ -3.2, 3.05, 4.5 }, { 3.2, 3.05, 4.5 }, .07, fine.Sides, 2 * fine.Rings);
  for (const double x : { -3.2, 3.2 })
  {
    for (const double z : { 3.3, 5.7 })
    {
      mesh.Tube({ x, 0, z }, { x, 3.05, 4.5 }, .06, fine.Sides, fine.Rings);
    }
  }
}

void AddTubeSlide(MeshBuilder& mesh, const Fineness& fine)
{
  Points helix;
  for (const double t : Linspace(0, 1, 12 * fine.Rings - 1))
  {
    helix.emplace_back(7.5 + 1.3 * std::cos(9 * t), 3.6 * (1 - t) + .2, 3 + 1.3 * std::sin(9 * t));
  }
  mesh.Sweep(helix, { .42 }, 2 * fine.Sides);
  mesh.Tube({ 7.5, 0, 3 }, { 7.5, 4.2, 3 }, .12, fine.Sides, 2 * fine.Rings);
}

void AddBalls(MeshBuilder& mesh, int fineness)
{
  Random random(4);
  for (int k = 0; k < 7; ++k)
  {
    const double x = random.Uniform(-8, 9);
    mesh.Sphere({ x, .3, random.Uniform(-6, 9) }, .3, fineness);
  }
}

// A rope net between two posts.
void AddNet(MeshBuilder& mesh, const Fineness& fine)
{
  const int sides = std::max(3, fine.Sides / 4);
  for (int k = 0; k < 32; ++k)
  {
    const double y = .1 + .09 * k, x = -9 + .125 * k, z = -4 - .0625 * k;
    mesh.Tube({ -9, y, -4 }, { -5, y, -6 }, .008, sides, fine.Rings);
    mesh.Tube({ x, .1, z }, { x, 2.9, z }, .008, sides, fine.Rings);
  }
}
}

Scene MakePlayground(double scale)
{
  const double q = std::sqrt(scale);
  const Fineness fine{ std::max(4, int(44 * q)), std::max(2, int(22 * q)) };
  MeshBuilder mesh;
  mesh.Ground(-40, 40, -40, 40, Finer(40, std::min(1.0, 2 * q), 4));
  AddDome(mesh, fine);
  AddCubeFrame(mesh, fine);
  AddSwings(mesh, fine);
  AddTubeSlide(mesh, fine);
  AddBalls(mesh, int(24 * q) + 4);
  AddNet(mesh, fine);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { -6.5, 3.6, 12.5 }, { .6, .9, 0 }, { 0, 1, 0 }, 45, .5, 120 };
  scene.Path = { { { -2.5, 3.0, 13.5 }, { .8, 1, 0 } }, { { 3.5, 4.2, 12.0 }, { .2, .9, -.5 } },
    { { -1.5, 5.0, 11.0 }, { -.2, .8, 0 } } };
  scene.Light.Direction = Unit({ -.55, -.72, -.35 });
  return scene;
}
}
