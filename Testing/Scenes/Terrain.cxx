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
constexpr double SIDE = 2400; // metres

// Gradient noise (Perlin, Improving Noise, 2002) on a periodic lattice, with a quintic blend so
// that its second derivative is continuous too.
class GradientNoise
{
public:
  explicit GradientNoise(Random& random)
  {
    for (glm::dvec2& gradient : this->Gradients)
    {
      const double angle = random.Uniform(0, 2 * PI);
      gradient = { std::cos(angle), std::sin(angle) };
    }
  }

  double operator()(glm::dvec2 p) const
  {
    const glm::dvec2 corner = glm::floor(p), f = p - corner;
    const glm::dvec2 blend = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    const auto at = [&](int x, int y) {
      const glm::dvec2 offset(x, y);
      return glm::dot(this->Gradient(glm::ivec2(corner) + glm::ivec2(x, y)), f - offset);
    };
    const double low = glm::mix(at(0, 0), at(1, 0), blend.x);
    return glm::mix(low, glm::mix(at(0, 1), at(1, 1), blend.x), blend.y);
  }

private:
  static constexpr int CELLS = 64;

  const glm::dvec2& Gradient(glm::ivec2 cell) const
  {
    const int x = cell.x & (CELLS - 1), y = cell.y & (CELLS - 1);
    return this->Gradients[y * CELLS + x];
  }

  glm::dvec2 Gradients[CELLS * CELLS];
};

// Octaves that are fainter in the valleys than on the ridges, as on eroded land.
double Height(const GradientNoise& noise, glm::dvec2 p)
{
  double height = 0, amplitude = 190, weight = 1;
  glm::dvec2 q = p / 900.0;
  for (int octave = 0; octave < 5; ++octave)
  {
    const double ridge = 1 - std::sqrt(std::pow(noise(q), 2) + 0.01) * 1.6;
    height += amplitude * weight * ridge * ridge;
    weight = std::clamp(ridge, 0.0, 1.0);
    amplitude *= 0.4;
    q = glm::dvec2(0.8 * q.x - 0.6 * q.y, 0.6 * q.x + 0.8 * q.y) * 2.03 + 7.3; // turned
  }
  return height;
}
}

Scene MakeTerrain(double scale)
{
  Random random(6);
  const GradientNoise noise(random);
  const int n = std::max(8, int(std::lround(400 * std::sqrt(scale))));
  MeshBuilder mesh;
  const auto point = [&](double u, double v) {
    const glm::dvec2 p((u - 0.5) * SIDE, (v - 0.5) * SIDE);
    return dvec3(p.x, Height(noise, p), p.y);
  };
  mesh.Grid(point, n, n);

  Scene scene;
  scene.Mesh = mesh.Build();
  const dvec3 eye(150, Height(noise, { 150, 1000 }) + 110, 1000);
  scene.Camera = { eye, { -60, 60, 0 }, { 0, 1, 0 }, 40, 2, 4000 };
  const auto over = [&](double x, double z, double height) {
    return dvec3(x, Height(noise, { x, z }) + height, z);
  };
  scene.Path = { { over(210, 900, 130), { -20, 60, -60 } },
    { over(60, 800, 170), { -40, 40, -200 } }, { over(0, 960, 150), { 10, 60, -40 } } };
  const double elevation = 12 * PI / 180, heading = 35 * PI / 180; // the sun is ahead, to the left
  scene.Light.Direction = { std::cos(elevation) * std::cos(heading), -std::sin(elevation),
    std::cos(elevation) * std::sin(heading) };
  return scene;
}
}
