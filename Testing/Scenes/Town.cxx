// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkPolyData.h>

#include <algorithm>

namespace rtw
{
namespace
{
void AddHouse(MeshBuilder& mesh, Random& random, double streetX, double streetZ)
{
  const double x = streetX + random.Uniform(-3, 3), z = streetZ + random.Uniform(-4, 4);
  const double w = random.Uniform(7, 11), d = random.Uniform(8, 13);
  const double h = random.Uniform(3, 6.5), roof = random.Uniform(2, 4);
  const double turn = random.Uniform(-.15, .15);
  mesh.Box({ x, h / 2, z }, { w, h, d }, turn);

  const double eaves = .6;
  Points gables = { { -w / 2 - eaves, h - .2, -d / 2 - eaves },
    { w / 2 + eaves, h - .2, -d / 2 - eaves }, { 0, h + roof, -d / 2 - eaves },
    { -w / 2 - eaves, h - .2, d / 2 + eaves }, { w / 2 + eaves, h - .2, d / 2 + eaves },
    { 0, h + roof, d / 2 + eaves } };
  for (dvec3& p : gables)
  {
    p = TurnY(p, turn) + dvec3(x, 0, z);
  }
  mesh.Add(gables,
    { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 3, 5 }, { 0, 5, 2 }, { 1, 2, 5 }, { 1, 5, 4 }, { 0, 1, 4 },
      { 0, 4, 3 } });
  mesh.Box({ x + w / 4, h + roof * .8, z }, { .9, 2.2, .9 }, turn); // chimney

  const double side = x > 0 ? -1 : 1;
  for (int k = -2; k <= 2; ++k) // window frames on the street front
  {
    mesh.Box({ x + side * (w / 2 + .05), h * .55, z + k * d / 6 }, { .12, 1.3, .9 }, turn);
  }
}

// `density` thins out what stands along it.
void AddStreet(MeshBuilder& mesh, double density)
{
  for (const double side : { -1., 1. })
  {
    for (const double z : Arange(200, 292, .35 / density)) // picket fence
    {
      mesh.Box({ side * 7, .55, z }, { .04, 1.1, .12 });
    }
    for (const double y : { .3, .85 })
    {
      mesh.Box({ side * 7, y, 246 }, { .05, .08, 92 });
    }
    for (const double z : Arange(-280, 292, 24 / density)) // lamps
    {
      mesh.Tube({ side * 5.5, 0, z }, { side * 5.5, 6, z }, .09, 8);
      mesh.Tube({ side * 5.5, 6, z }, { side * 4, 6.3, z }, .06, 6);
      mesh.Sphere({ side * 4, 6.2, z }, .3, 5);
    }
  }
}

struct Place
{
  double X, Z;
};

std::vector<Place> PlaceTrees(Random& random, double density)
{
  std::vector<Place> trees;
  for (const double z : Arange(-280, 292, 13 / density))
  {
    for (const double side : { -1., 1. })
    {
      const double x = side * random.Uniform(9.5, 12);
      trees.push_back({ x, z + random.Uniform(-4, 4) });
    }
  }
  for (int k = 0; k < Finer(160, density, 1); ++k)
  {
    const double x = random.Uniform(-150, 150);
    trees.push_back({ x, random.Uniform(-290, 290) });
  }
  return trees;
}

dvec3 NormalVector(Random& random)
{
  const double x = random.Normal(), y = random.Normal();
  return { x, y, random.Normal() };
}

Points NormalVectors(Random& random, int count)
{
  Points vectors(count);
  for (dvec3& v : vectors)
  {
    v = NormalVector(random);
  }
  return vectors;
}

std::vector<double> UniformNumbers(Random& random, double low, double high, int count)
{
  std::vector<double> numbers(count);
  for (double& x : numbers)
  {
    x = random.Uniform(low, high);
  }
  return numbers;
}

struct Foliage
{
  int Leaves;  // of a tree
  double Size; // of a leaf
};

// Rhombic leaves about the middle of a crown.
void AddLeaves(MeshBuilder& mesh, Random& random, const dvec3& crown, const Foliage& foliage)
{
  const int count = foliage.Leaves;
  const Points directions = NormalVectors(random, count);
  const std::vector<double> distances = UniformNumbers(random, .35, 1, count);
  const Points normals = NormalVectors(random, count), across = NormalVectors(random, count);
  const std::vector<double> sizes = UniformNumbers(random, .10, .2, count);
  Points points;
  Triangles halves, otherHalves;
  for (int i = 0; i < count; ++i)
  {
    const dvec3 p = crown + Unit(directions[i]) * distances[i] * dvec3(2.3, 2.0, 2.3);
    const dvec3 n = Unit(normals[i] + dvec3(0, .6, 0));
    const dvec3 a = Unit(glm::cross(n, across[i])), b = glm::cross(n, a);
    const double s = sizes[i] * foliage.Size;
    points.insert(points.end(), { p - a * s, p - b * s * .6, p + a * s, p + b * s * .6 });
    halves.emplace_back(4 * i, 4 * i + 1, 4 * i + 2);
    otherHalves.emplace_back(4 * i, 4 * i + 2, 4 * i + 3);
  }
  halves.insert(halves.end(), otherHalves.begin(), otherHalves.end());
  mesh.Add(points, halves);
}

void AddTree(MeshBuilder& mesh, Random& random, const Place& place, const Foliage& foliage)
{
  const double x = place.X, z = place.Z, h = random.Uniform(5, 9);
  mesh.Cone({ x, 0, z }, { x, h * .7, z }, .22, .1, 8, 3);
  const dvec3 crown(x, h * .75, z);
  for (int k = 0; k < 6; ++k) // branches
  {
    const dvec3 from(x, h * random.Uniform(.35, .6), z);
    mesh.Cone(from, crown + NormalVector(random) * dvec3(1.1, .7, 1.1), .06, .02, 5, 1);
  }
  AddLeaves(mesh, random, crown, foliage);
}
}

// Trees have more leaves, and smaller ones where there are more than at 1, or crowns would be
// solid. Below 65 000 triangles there are no leaves left to lose, and the town thins out.
Scene MakeTown(double scale)
{
  const double density = std::min(1.0, scale / 0.13);
  Random random(1);
  MeshBuilder mesh;
  mesh.Ground(-300, 300, -300, 300, Finer(40, std::sqrt(density), 4));
  for (int row = 0; row < 5; ++row)
  {
    for (const double side : { -1., 1. })
    {
      for (const double z : Arange(-270, 290, 28 / density))
      {
        AddHouse(mesh, random, side * (16 + 26 * row), z);
      }
    }
  }
  AddStreet(mesh, density);
  const std::vector<Place> trees = PlaceTrees(random, density);
  const double left = 500000 * scale - double(mesh.NumberOfTriangles());
  const int leaves = std::max(8, int(left / double(trees.size()) / 2) - 40);
  const Foliage foliage{ leaves, 1 / std::max(1.0, std::sqrt(scale)) };
  for (const Place& tree : trees)
  {
    AddTree(mesh, random, tree, foliage);
  }

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 0.8, 1.9, 291 }, { -1.2, 2.6, 200 }, { 0, 1, 0 }, 55, .6, 600 };
  scene.Path = { { { 2.4, 1.8, 284 }, { -3, 2.4, 200 } }, { { -1.0, 2.4, 272 }, { 1.5, 2.6, 190 } },
    { { -2.6, 2.2, 282 }, { 2.5, 2.6, 195 } } };
  scene.Light.Direction = Unit({ -.75, -.62, .25 });
  return scene;
}
}
