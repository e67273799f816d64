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
constexpr int SEGMENTS = 12;

Points UnitVectors(Random& random, int count)
{
  Points vectors(count);
  for (dvec3& v : vectors)
  {
    const double x = random.Normal(), y = random.Normal();
    v = Unit({ x, y, random.Normal() });
  }
  return vectors;
}

std::vector<double> Numbers(Random& random, double low, double high, int count)
{
  std::vector<double> numbers(count);
  for (double& x : numbers)
  {
    x = random.Uniform(low, high);
  }
  return numbers;
}

// Flat ribbons that curl, droop and taper. The numbers of all hairs are drawn kind by kind.
// More hairs are thinner ones, so that as much light gets between them.
void AddHairs(MeshBuilder& mesh, Random& random, int hairs, double width)
{
  const Points directions = UnitVectors(random, hairs), across = UnitVectors(random, hairs);
  const std::vector<double> curls = Numbers(random, .02, .09, hairs);
  const std::vector<double> phases = Numbers(random, 0, 6.28, hairs);
  const std::vector<double> turns = Numbers(random, 2, 7, hairs);
  const std::vector<double> lengths = Numbers(random, .5, .85, hairs);
  const Points widths = UnitVectors(random, hairs);

  Points points;
  Triangles lower, upper;
  for (int hair = 0; hair < hairs; ++hair)
  {
    const dvec3 d = directions[hair];
    const dvec3 a = Unit(glm::cross(d, across[hair])), b = glm::cross(d, a);
    const dvec3 side = Unit(glm::cross(d, widths[hair]));
    for (const double t : Linspace(0, 1, SEGMENTS))
    {
      const double angle = phases[hair] + t * turns[hair];
      dvec3 c = d * (.44 + lengths[hair] * t) +
        curls[hair] * t * (a * std::cos(angle) + b * std::sin(angle));
      c.y -= .18 * (t * t) * lengths[hair];
      const dvec3 half = side * (width * (1 - .8 * t));
      points.push_back(c - half);
      points.push_back(c + half);
    }
    for (int i = 0; i < SEGMENTS; ++i)
    {
      const int k = (hair * (SEGMENTS + 1) + i) * 2;
      lower.emplace_back(k, k + 1, k + 2);
      upper.emplace_back(k + 2, k + 1, k + 3);
    }
  }
  lower.insert(lower.end(), upper.begin(), upper.end());
  mesh.Add(points, lower);
}
}

Scene MakeFurball(double scale)
{
  const double root = std::sqrt(scale);
  Random random(3);
  MeshBuilder mesh;
  mesh.Ground(-6, 6, -3, 9, 8, -1.6);
  mesh.Grid([](double u, double v) { return dvec3(-6 + 12 * u, -1.6 + 8 * v, -2.5); }, 8, 8);
  mesh.Sphere({ 0, 0, 0 }, .45, Finer(24, root, 5));
  AddHairs(mesh, random, Finer(4000, scale, 10), .0045 / root);

  Scene scene;
  scene.Mesh = mesh.Build();
  scene.Camera = { { 2.6, .9, 4.6 }, { -.4, -.5, -.6 }, { 0, 1, 0 }, 40, .5, 30 };
  scene.Path = { { { 4.4, .2, 2.4 }, { -.3, -.5, -.5 } }, { { 4.2, 1.8, 2.8 }, { -.2, -.6, -.4 } },
    { { .8, 2.2, 4.9 }, { -.2, -.6, -.8 } } };
  const dvec3 position(4.2, 4.4, 3.6);
  scene.Light = { true, position, Unit(dvec3(-.4, -.5, -.6) - position), 35 };
  return scene;
}
}
