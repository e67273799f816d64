// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

#include <glm/gtc/matrix_transform.hpp>

#include <stdexcept>

namespace rtw
{
namespace
{
const double PI = std::acos(-1.0);
constexpr double SIDE = 10; // of the whole machine

// A surface of revolution about y, of about so many triangles; the first and the last radius are 0.
void AddLathe(MeshBuilder& mesh, const Points& profile, int triangles)
{
  const int segments = int(profile.size()) - 1; // the two at the ends have half the triangles
  const int sides = std::max(3, int(std::lround(triangles / (2.0 * (segments - 1)))));
  Points path;
  std::vector<double> radii;
  for (const dvec3& p : profile)
  {
    path.push_back({ 0, p.y, 0 });
    radii.push_back(p.x);
  }
  mesh.Sweep(path, radii, sides);
}

void AddBolt(MeshBuilder& mesh, int triangles)
{
  AddLathe(mesh,
    { { 0, 1, 0 }, { .9, .999, 0 }, { 1, .35, 0 }, { .55, .349, 0 }, { .5, -1, 0 },
      { 0, -1.001, 0 } },
    triangles);
}

// A box whose sides are grids.
void AddPlate(MeshBuilder& mesh, int triangles)
{
  const int n = std::max(1, int(std::lround(std::sqrt(triangles / 12.0))));
  for (const double side : { -.5, .5 })
  {
    mesh.Grid([=](double u, double v) { return dvec3(u - .5, side, v - .5); }, n, n);
    mesh.Grid([=](double u, double v) { return dvec3(side, u - .5, v - .5); }, n, n);
    mesh.Grid([=](double u, double v) { return dvec3(u - .5, v - .5, side); }, n, n);
  }
}

void AddShaft(MeshBuilder& mesh, int triangles)
{
  const int sides = std::max(3, int(std::lround(std::sqrt(double(triangles)))));
  mesh.Tube({ 0, -.5, 0 }, { 0, .5, 0 }, 1, sides,
    std::max(1, int(std::lround(triangles / (2.0 * sides)))));
}

void AddRing(MeshBuilder& mesh, int triangles)
{
  const int sides = std::max(3, int(std::lround(std::sqrt(triangles / 4.0))));
  mesh.Torus({ 0, 0, 0 }, 1, .22, std::max(4, int(std::lround(triangles / (2.0 * sides)))), sides);
}

void AddSpring(MeshBuilder& mesh, int triangles)
{
  const int sides = std::max(3, int(std::lround(std::sqrt(triangles / 4.0))));
  const int steps = std::max(6, int(std::lround(triangles / (2.0 * sides))));
  Points coil;
  for (const double t : Linspace(0, 1, steps))
  {
    coil.emplace_back(std::cos(5 * PI * t), t - .5, std::sin(5 * PI * t));
  }
  mesh.Sweep(coil, { .09 }, sides);
}

// Teeth of four corners each, between two flat sides.
void AddGear(MeshBuilder& mesh, int triangles)
{
  const int corners = 4 * std::max(3, int(std::lround(triangles / 16.0)));
  Points points = { { 0, .5, 0 }, { 0, -.5, 0 } };
  Triangles cells;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2 * PI * i / corners, radius = i % 4 < 2 ? 1 : .78;
    const int k = 2 + 2 * i, next = 2 + 2 * ((i + 1) % corners);
    points.emplace_back(radius * std::cos(angle), .5, radius * std::sin(angle));
    points.emplace_back(radius * std::cos(angle), -.5, radius * std::sin(angle));
    cells.insert(cells.end(),
      { { 0, next, k }, { 1, k + 1, next + 1 }, { k, next, k + 1 }, { k + 1, next, next + 1 } });
  }
  mesh.Add(points, cells);
}

struct Kind
{
  vtkSmartPointer<vtkPolyData> Mesh;
  dvec3 Colour;
};

Kind MakeKind(void (*add)(MeshBuilder&, int), int triangles, const dvec3& colour)
{
  MeshBuilder mesh;
  add(mesh, triangles);
  return { mesh.Build(), colour };
}

// The machine's parts, in an order in which the first ones alone make sense too.
class Machine
{
public:
  Machine(int actors, int triangles)
    : Actors(size_t(actors))
    , Plate(MakeKind(AddPlate, triangles, { .62, .66, .70 }))
    , Bolt(MakeKind(AddBolt, triangles, { .35, .36, .38 }))
    , Shaft(MakeKind(AddShaft, triangles, { .80, .80, .82 }))
    , Gear(MakeKind(AddGear, triangles, { .78, .62, .32 }))
    , Ring(MakeKind(AddRing, triangles, { .72, .38, .28 }))
    , Spring(MakeKind(AddSpring, triangles, { .45, .52, .42 }))
  {
    const int stations = std::max(1, (actors - 1 + PARTS - 1) / PARTS);
    this->Across = int(std::ceil(std::sqrt(double(stations)) - 1e-9));
    this->Put(this->Plate, { 0, -.25, 0 }, { 3 * SIDE, .5, 3 * SIDE }); // the bed
    for (int i = 0; i < stations; ++i)
    {
      this->AddStation(i);
    }
  }

  std::vector<ScenePart> Parts;

private:
  static constexpr int PARTS = 9; // of a station

  void Put(const Kind& kind, const dvec3& at, const dvec3& size, double turn = 0, double tilt = 0)
  {
    if (this->Parts.size() < this->Actors)
    {
      glm::dmat4 placement = glm::translate(glm::dmat4(1), at);
      placement = glm::rotate(placement, turn, dvec3(0, 1, 0));
      placement = glm::rotate(placement, tilt, dvec3(1, 0, 0));
      this->Parts.push_back(
        { PartKind::SURFACE, kind.Mesh, nullptr, glm::scale(placement, size), kind.Colour });
    }
  }

  // A plate on four bolts, with a gear and rings on a shaft, and a spring beside it.
  void AddStation(int i)
  {
    const double apart = SIDE / this->Across, cell = std::min(apart, SIDE / 10);
    const auto in = [&](double x, double y, double z) {
      return dvec3((i % this->Across + .5) * apart + x * cell - SIDE / 2, y * cell,
        (i / this->Across + .5) * apart + z * cell - SIDE / 2);
    };
    const double height = this->Numbers.Uniform(.25, .9), turn = this->Numbers.Uniform(0, 6.28);
    const double gear = this->Numbers.Uniform(.22, .40), lean = this->Numbers.Uniform(-.35, .35);
    this->Put(this->Plate, in(0, height, 0), dvec3(.86, .05, .86) * cell);
    for (const double x : { -.35, .35 })
    {
      for (const double z : { -.35, .35 })
      {
        // Their shanks are the plate's legs.
        this->Put(this->Bolt, in(x, .52 * height, z), dvec3(.07, .56 * height, .07) * cell, turn);
      }
    }
    this->Put(this->Shaft, in(-.1, height + .45, 0), dvec3(.05, .9, .05) * cell, turn, lean);
    const dvec3 up(0, std::cos(lean), std::sin(lean));
    const dvec3 along = TurnY(up, turn);
    this->Put(this->Gear, in(-.1, height + .45, 0) + along * (.1 * cell),
      dvec3(gear, .08, gear) * cell, turn, lean);
    this->Put(
      this->Ring, in(-.1, height + .45, 0) + along * (.32 * cell), dvec3(.11 * cell), turn, lean);
    this->Put(this->Spring, in(.3, height + .225, .12), dvec3(.09, .4, .09) * cell, turn);
  }

  size_t Actors;
  int Across = 1;
  Kind Plate, Bolt, Shaft, Gear, Ring, Spring;
  Random Numbers{ 8 };
};
}

Scene MakeAssemblyOf(int actors, int trianglesPerActor)
{
  if (actors < 1)
  {
    throw std::invalid_argument("an assembly has at least one actor");
  }
  Scene scene;
  scene.Name = "assembly";
  scene.Mesh = vtkSmartPointer<vtkPolyData>::New();
  scene.Parts = Machine(actors, std::max(50, trianglesPerActor)).Parts;
  scene.Camera = { { 5.2, 4.2, 8.4 }, { -.3, .2, -.3 }, { 0, 1, 0 }, 45, .5, 50 };
  scene.Path = { { { 7.6, 3.4, 5.2 }, { 0, .3, -.4 } }, { { 6.4, 2.6, 6.4 }, { -.6, .5, -.6 } },
    { { 3.0, 5.4, 8.6 }, { -.2, .2, -.4 } } };
  scene.Light.Direction = Unit({ -.62, -.66, -.30 });
  return scene;
}

// The parts become finer; where they would be too coarse to be what they are, there are fewer.
Scene MakeAssembly(double scale)
{
  return scale < 0.5 ? MakeAssemblyOf(Finer(2000, scale, 10), 50)
                     : MakeAssemblyOf(1000, Finer(100, scale, 50));
}
}
