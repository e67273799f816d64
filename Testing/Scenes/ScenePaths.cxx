// SPDX-License-Identifier: BSD-3-Clause
#include "rtwScene.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace rtw
{
namespace
{
using glm::dvec3;

const double PI = std::acos(-1.0);

// Between b, at 0, and c, at 1: the cubic of Catmull and Rom, A Class of Local Interpolating
// Splines, 1974.
dvec3 Spline(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, double t)
{
  return b +
    0.5 * t * ((c - a) + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

dvec3 TurnAbout(const dvec3& v, const dvec3& axis, double angle)
{
  return dvec3(glm::rotate(glm::dmat4(1), angle, axis) * glm::dvec4(v, 0));
}

// A share of one oscillation.
double Phase(double t)
{
  return 2 * PI * (t - std::floor(t));
}

// In an eight about where it is.
SceneCamera Sway(SceneCamera camera, double t)
{
  const dvec3 from = camera.Position - camera.Focal;
  const dvec3 right = glm::normalize(glm::cross(camera.Up, from));
  const dvec3 turned = TurnAbout(from, right, glm::radians(6.0) * std::sin(2 * Phase(t)));
  camera.Position = camera.Focal +
    TurnAbout(turned, glm::normalize(camera.Up), glm::radians(20.0) * std::sin(Phase(t)));
  return camera;
}
}

SceneCamera CameraOnPath(const Scene& scene, double t)
{
  if (scene.Path.empty())
  {
    return Sway(scene.Camera, t);
  }
  std::vector<WayPoint> points = { { scene.Camera.Position, scene.Camera.Focal } };
  points.insert(points.end(), scene.Path.begin(), scene.Path.end());
  const double along = (t - std::floor(t)) * double(points.size());
  const size_t first = std::min(size_t(along), points.size() - 1);
  const auto at = [&](size_t offset) -> const WayPoint& {
    return points[(first + points.size() + offset - 1) % points.size()];
  };
  const auto between = [&](dvec3 WayPoint::*member) {
    return Spline(
      at(0).*member, at(1).*member, at(2).*member, at(3).*member, along - double(first));
  };
  SceneCamera camera = scene.Camera;
  camera.Position = between(&WayPoint::Position);
  camera.Focal = between(&WayPoint::Focal);
  return camera;
}

// A slow turn, so that moves are not along pixels. What is far moves by the camera's turning, what
// is near by its position too, which moves as far as that part of a pixel is wide at ten times the
// nearest depth: about where the nearest things are.
SceneCamera CameraOnTinyPath(const Scene& scene, int frame, double t, double pixels)
{
  SceneCamera camera = CameraOnPath(scene, t);
  const dvec3 ahead = camera.Focal - camera.Position;
  const dvec3 right = glm::normalize(glm::cross(ahead, camera.Up));
  const dvec3 up = glm::normalize(glm::cross(right, ahead));
  const double step = pixels * 2 * std::tan(glm::radians(camera.Angle / 2)) / double(scene.Size[1]);
  dvec3 moved(0);
  for (int i = 0; i < frame; ++i)
  {
    const double heading = 0.5 + 0.05 * i;
    moved += step * (std::cos(heading) * right + std::sin(heading) * up);
  }
  camera.Position += moved * (10 * camera.Near);
  camera.Focal = camera.Position + ahead + moved * glm::length(ahead);
  return camera;
}

SceneLight LightOnPath(const Scene& scene, double t)
{
  SceneLight light = scene.Light;
  const dvec3 up = glm::normalize(scene.Camera.Up);
  const double angle = glm::radians(scene.LightSwing) * 0.5 * (1 - std::cos(Phase(t)));
  light.Direction = TurnAbout(light.Direction, up, angle);
  if (light.IsSpot)
  {
    light.Position = scene.Camera.Focal + TurnAbout(light.Position - scene.Camera.Focal, up, angle);
  }
  return light;
}
}
