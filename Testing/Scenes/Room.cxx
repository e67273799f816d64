// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

namespace rtw
{
namespace
{
const double PI = std::acos(-1.0);
constexpr dvec3 LAMP(-.1, 1.9, -.1);

// Walls with a window frame in one of them, and curtains beside it.
void AddShell(MeshBuilder& mesh, double root)
{
  const int n = Finer(8, root, 1);
  mesh.Ground(-3, 3, -2.6, 2.6, n);
  mesh.Ground(-3, 3, -2.6, 2.6, n, 2.7);
  for (const double side : { -1., 1. })
  {
    mesh.Grid([=](double u, double v) { return dvec3(3 * side, 2.7 * u, -2.6 + 5.2 * v); }, n, n);
    mesh.Grid([=](double u, double v) { return dvec3(-3 + 6 * u, 2.7 * v, 2.6 * side); }, n, n);
    const auto curtain = [=](double u, double v) {
      const double gather = 1 - .25 * std::exp(-20 * (v - .45) * (v - .45)); // held by a band
      return dvec3(
        -2.86 + .05 * std::sin(44 * u), .05 + 2.4 * v, .3 + side * (1.5 - .75 * u * gather));
    };
    mesh.Grid(curtain, Finer(96, root, 12), Finer(24, root, 4));
    mesh.Box({ 2.98, .05, side * 1.3 }, { .03, .1, 2.6 });
    mesh.Box({ -2.985, .05, side * 1.3 }, { .03, .1, 2.6 });
  }
  mesh.Box({ 0, .05, -2.585 }, { 6, .1, .03 });
  mesh.Tube({ -2.86, 2.5, -1.4 }, { -2.86, 2.5, 2 }, .018, Finer(10, root, 4));
  for (const double z : Linspace(-.4, 1, 3)) // the window's bars
  {
    mesh.Box({ -2.97, 1.5, z }, { .06, 1.5, .04 });
  }
  for (const double y : Linspace(.75, 2.25, 3))
  {
    mesh.Box({ -2.97, y, .3 }, { .06, .04, 1.44 });
  }
}

ScenePart MakeLamp(double root)
{
  MeshBuilder mesh;
  const int sides = Finer(40, root, 8), rings = Finer(4, root, 1);
  mesh.Sphere(LAMP + dvec3(0, .08, 0), .045, Finer(12, root, 4));
  mesh.Cone(LAMP + dvec3(0, .09, 0), LAMP + dvec3(0, .26, 0), .26, .07, sides, rings);
  mesh.Cone(LAMP + dvec3(0, .26, 0), LAMP + dvec3(0, .33, 0), .07, .015, sides, 1);
  mesh.Tube(LAMP + dvec3(0, .33, 0), { LAMP.x, 2.7, LAMP.z }, .008, Finer(6, root, 3));
  ScenePart lamp;
  lamp.Data = mesh.Build();
  lamp.Colour = { 1, .93, .75 };
  lamp.Ambient = 1; // it glows
  return lamp;
}

void AddTable(MeshBuilder& mesh, double root)
{
  const int sides = Finer(20, root, 5), ball = Finer(12, root, 4);
  mesh.Box({ 0, .73, 0 }, { 1.7, .04, .95 });
  mesh.Box({ 0, .67, 0 }, { 1.5, .08, .75 });
  for (const double x : { -.76, .76 })
  {
    for (const double z : { -.39, .39 })
    {
      mesh.Cone({ x, .71, z }, { x, 0, z }, .04, .022, sides, Finer(3, root, 1));
    }
  }
  for (const double x : { -.5, .0, .48 }) // plates and cups
  {
    for (const double z : { -.27, .27 })
    {
      mesh.Cone({ x, .752, z }, { x, .768, z }, .07, .115, 2 * sides, 1);
      mesh.Torus({ x, .768, z }, .115, .004, 2 * sides, Finer(6, root, 3));
      mesh.Cone({ x + .19, .75, z }, { x + .19, .83, z }, .025, .036, sides, 2);
      mesh.Torus({ x + .226, .79, z }, .02, .005, sides, Finer(6, root, 3), { Axis::Z, 1, .4 });
    }
  }
  mesh.Sphere({ .24, .83, .0 }, .08, ball); // a pot
  mesh.Cone({ .30, .83, 0 }, { .40, .89, .03 }, .022, .010, sides, 2);
  mesh.Torus({ .15, .84, 0 }, .05, .008, sides, Finer(6, root, 3), { Axis::Z, 1, 0 });
  mesh.Cone({ -.25, .752, 0 }, { -.25, .80, 0 }, .05, .15, 2 * sides, 2); // a bowl of fruit
  for (int k = 0; k < 6; ++k)
  {
    const double a = k * PI / 3;
    mesh.Sphere({ -.25 + .075 * std::cos(a), .82, .075 * std::sin(a) }, .036, ball);
  }
}

void AddChair(MeshBuilder& mesh, double root, const dvec3& at, double turn)
{
  const int sides = Finer(12, root, 4);
  const auto place = [&](double x, double y, double z) { return TurnY({ x, y, z }, turn) + at; };
  const auto rod = [&](const dvec3& from, const dvec3& to, double radius) {
    mesh.Tube(
      place(from.x, from.y, from.z), place(to.x, to.y, to.z), radius, sides, Finer(2, root, 1));
  };
  mesh.Box(place(0, .45, 0), { .42, .035, .42 }, turn);
  for (const double x : { -.17, .17 })
  {
    rod({ x, .44, .17 }, { 1.15 * x, 0, .2 }, .017);
    rod({ x, .44, -.17 }, { 1.15 * x, 0, -.21 }, .017);
    rod({ x, .18, .19 }, { x, .18, -.19 }, .010);
    rod({ x, .46, -.18 }, { 1.1 * x, .95, -.26 }, .015);
  }
  for (const double x : Linspace(-.12, .12, 5)) // spindles
  {
    rod({ x, .46, -.18 }, { 1.1 * x, .93, -.26 }, .007);
  }
  mesh.Box(place(0, .93, -.26), { .42, .07, .025 }, turn);
}

void AddShelf(MeshBuilder& mesh, Random& random)
{
  const double left = -2.7, right = -.7, z = -2.42;
  for (const double x : { left, right })
  {
    mesh.Box({ x, 1, z }, { .03, 2, .32 });
  }
  for (const double y : Linspace(.08, 1.98, 5))
  {
    mesh.Box({ (left + right) / 2, y, z }, { right - left, .025, .32 });
    for (double x = left + .03; x < right - .08 && y < 1.9;)
    {
      const double width = random.Uniform(.015, .05), height = random.Uniform(.18, .33);
      const double depth = random.Uniform(.14, .24);
      if (random.Uniform() < .9) // or a gap
      {
        mesh.Box({ x + width / 2, y + .0125 + height / 2, z + .14 - depth / 2 },
          { .93 * width, height, depth });
      }
      x += width;
    }
  }
}

// Leaves that bend over, on stems from a pot. More leaves are smaller ones.
void AddPlant(MeshBuilder& mesh, Random& random, const dvec3& at, double height, double scale)
{
  const double root = std::sqrt(scale), size = .09 / std::max(1.0, root);
  mesh.Cone(at, at + dvec3(0, .3 * height, 0), .11 * height, .16 * height, Finer(24, root, 6), 2);
  for (int stem = 0; stem < 14; ++stem)
  {
    const double heading = random.Uniform(0, 2 * PI), reach = random.Uniform(.1, .38) * height;
    const double rise = random.Uniform(.45, 1) * height;
    const dvec3 out(std::cos(heading), 0, std::sin(heading));
    const auto along = [&](double t) {
      return at + dvec3(0, .28 * height + (rise - .28 * height) * t, 0) + out * (reach * t * t);
    };
    mesh.Sweep({ along(0), along(.35), along(.7), along(1) }, { .008, .006, .005, .002 }, 5);
    for (int leaf = 0; leaf < Finer(120, scale, 4); ++leaf)
    {
      const dvec3 from = along(random.Uniform(.25, 1));
      const double angle = random.Uniform(0, 2 * PI), lift = random.Uniform(-.4, .8);
      const dvec3 way = Unit({ std::cos(angle), lift, std::sin(angle) });
      const dvec3 side = Unit(glm::cross(way, dvec3(.1, 1, 0))) * (.22 * size);
      const dvec3 middle = from + way * (.5 * size),
                  tip = from + way * size - dvec3(0, .4 * size, 0);
      mesh.Add({ from, middle - side, middle + side, tip }, { { 0, 1, 2 }, { 1, 3, 2 } });
    }
  }
}

// A shaggy one. More blades are thinner ones.
void AddRug(MeshBuilder& mesh, Random& random, double scale)
{
  mesh.Box({ 0, .004, 0 }, { 3.8, .008, 3 });
  const double width = .006 / std::sqrt(scale);
  for (int blade = 0; blade < Finer(16000, scale, 100); ++blade)
  {
    const double x = random.Uniform(-1.9, 1.9), z = random.Uniform(-1.5, 1.5);
    const double angle = random.Uniform(0, 2 * PI), height = random.Uniform(.015, .035);
    const dvec3 across(width * std::cos(angle), 0, width * std::sin(angle)), foot(x, .008, z);
    const double leanX = random.Uniform(-.012, .012), leanZ = random.Uniform(-.012, .012);
    mesh.Add({ foot - across, foot + across, foot + dvec3(leanX, height, leanZ) }, { { 0, 1, 2 } });
  }
}

void AddPictures(MeshBuilder& mesh)
{
  for (const double x : { -.1, .75, 1.6 })
  {
    const double w = .5, h = .4 + .12 * x;
    for (const double side : { -.5, .5 })
    {
      mesh.Box({ x + side * w, 1.35, -2.58 }, { .03, h, .03 });
      mesh.Box({ x, 1.35 + side * h, -2.58 }, { w + .03, .03, .03 });
    }
  }
  mesh.Box({ .9, .4, -2.38 }, { 1.5, .7, .4 }); // a sideboard
  for (const double x : { .4, .9, 1.4 })
  {
    mesh.Box({ x, .4, -2.17 }, { .46, .6, .015 });
    mesh.Box({ x + .17, .4, -2.15 }, { .015, .12, .02 });
  }
}
}

// Rounded things become finer, and the plants and the rug get more of what they have.
Scene MakeRoom(double scale)
{
  const double root = std::sqrt(scale);
  Random random(7);
  MeshBuilder mesh;
  AddShell(mesh, root);
  AddTable(mesh, root);
  AddChair(mesh, root, { -.45, 0, -.72 }, .12);
  AddChair(mesh, root, { .5, 0, -.78 }, -.2);
  AddChair(mesh, root, { -.55, 0, .8 }, PI + .25);
  AddChair(mesh, root, { -1.35, 0, .1 }, PI / 2 - .3);
  AddShelf(mesh, random);
  AddPlant(mesh, random, { -2.35, 0, 1.6 }, 1.3, scale);
  AddPlant(mesh, random, { 1.45, .75, -2.38 }, .55, scale);
  AddRug(mesh, random, scale);
  AddPictures(mesh);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Parts = { MakeLamp(root) };
  scene.Camera = { { 2.5, 1.75, 2.2 }, { -.55, .5, -.55 }, { 0, 1, 0 }, 60, .15, 12 };
  scene.Path = { { { 2.65, 1.35, .6 }, { -.7, .55, -.3 } }, { { 2.3, 1.9, -.9 }, { -.7, .45, .0 } },
    { { 2.6, 1.5, 1.0 }, { -.6, .5, -.6 } } };
  // As wide as a spot with a shadow map can sensibly be; with a cone of 90 it is a point light.
  scene.Light = { true, LAMP, { 0, -1, 0 }, 80 };
  return scene;
}
}
