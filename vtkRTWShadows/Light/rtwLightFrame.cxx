// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwLightFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtw
{
namespace
{
// The widest cone, in degrees from the axis: a wider one would give its middle next to no texels.
// What a light shines on beyond it stays unshadowed.
constexpr double WidestCone = 89.0;
// The share of a spot's reach within which all casters have one depth.
constexpr double NearestShare = 1e-3;

void SetRow(glm::dmat4& matrix, int row, const glm::dvec3& axis, double offset)
{
  for (int column = 0; column < 3; ++column)
  {
    matrix[column][row] = axis[column];
  }
  matrix[3][row] = offset;
}

// The axes of a light plane that is not turned.
struct Basis
{
  glm::dvec3 S, T;
};

Basis BasisOf(const glm::dvec3& direction)
{
  const glm::dvec3 across = std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 s = glm::normalize(glm::cross(across, direction));
  return { s, glm::cross(direction, s) };
}

void FitDirectional(LightFrame& frame, const ExtentFunction& extent, const glm::dvec3& eye)
{
  const glm::dvec3 axes[] = { frame.SAxis, frame.TAxis, frame.Light.Direction };
  glm::dvec3 low(0), high(0);
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec2 along = extent(axes[k]) - glm::dot(eye, axes[k]);
    low[k] = along.x;
    high[k] = along.y;
  }
  // A scene without extent still gets a square that a double can tell from a point.
  const double magnitude = std::max({ std::abs(low.x), std::abs(low.y), std::abs(high.x),
    std::abs(high.y) });
  const double side =
    std::max({ high.x - low.x, high.y - low.y, 1e-9 * magnitude, 1e-30 }) * 1.0001;
  const glm::dvec2 middle = 0.5 * glm::dvec2(low + high);
  frame.Bounds = { middle - 0.5 * side, middle + 0.5 * side };
  const double margin = 1e-3 * std::max(side, high.z - low.z);
  frame.DepthRange = high.z - low.z + 2 * margin;
  const double nearest = low.z - margin;
  SetRow(frame.WorldToLight, 0, frame.SAxis, -glm::dot(eye, frame.SAxis));
  SetRow(frame.WorldToLight, 1, frame.TAxis, -glm::dot(eye, frame.TAxis));
  SetRow(frame.WorldToLight, 2, frame.Light.Direction / frame.DepthRange,
    -(glm::dot(eye, frame.Light.Direction) + nearest) / frame.DepthRange);
  SetRow(frame.WorldToLight, 3, glm::dvec3(0), 1);
}

void FitSpot(LightFrame& frame, const ExtentFunction& extent, const glm::dvec3& eye)
{
  const ShadowLight& light = frame.Light;
  const glm::dvec2 along = extent(light.Direction) - glm::dot(light.Position, light.Direction);
  // A margin that doesn't grow with the distance of a lamp that is far from what it shines on.
  const double reach = std::max(along.y, 1e-30);
  double size = 1e-9 * reach;
  for (int axis = 0; axis < 3; ++axis) // of the world, however the frame is turned
  {
    const glm::dvec2 ends = extent(glm::dmat3(1)[axis]);
    size = std::max(size, ends.y - ends.x);
  }
  const double farthest = reach + 1e-3 * std::min(reach, size);
  const double nearest =
    std::max(along.x - 1e-3 * std::min(along.x, size), NearestShare * farthest);
  frame.NearestDistance = nearest;
  frame.FarthestDistance = farthest;
  frame.ConeTangent = std::tan(glm::radians(std::min(light.ConeAngle, WidestCone)));

  const glm::dvec3 toEye = eye - light.Position;
  const double eyeAlong = glm::dot(toEye, light.Direction);
  glm::dvec2 origin(0);
  if (eyeAlong > nearest)
  {
    origin = glm::dvec2(glm::dot(toEye, frame.SAxis), glm::dot(toEye, frame.TAxis)) / eyeAlong;
    origin = glm::clamp(origin, -2 * frame.ConeTangent, 2 * frame.ConeTangent);
  }
  frame.ConeCentre = -origin;
  frame.Bounds = { frame.ConeCentre - frame.ConeTangent, frame.ConeCentre + frame.ConeTangent };

  const glm::dvec3 s = frame.SAxis - origin.x * light.Direction;
  const glm::dvec3 t = frame.TAxis - origin.y * light.Direction;
  const double offset = -glm::dot(light.Position, light.Direction);
  // depth = (1/n - 1/w) / (1/n - 1/f)
  const double scale = 1 / (1 / nearest - 1 / farthest);
  SetRow(frame.WorldToLight, 0, s, -glm::dot(light.Position, s));
  SetRow(frame.WorldToLight, 1, t, -glm::dot(light.Position, t));
  SetRow(frame.WorldToLight, 2, light.Direction * scale / nearest, scale * (offset / nearest - 1));
  SetRow(frame.WorldToLight, 3, light.Direction, offset);
}
}

glm::dvec4 ShadowLight::GetOrigin() const
{
  return this->Kind == LightKind::Spot ? glm::dvec4(this->Position, 1)
                                       : glm::dvec4(-this->Direction, 0);
}

bool ShadowLight::operator==(const ShadowLight& other) const
{
  return this->Kind == other.Kind && this->Switched == other.Switched &&
    this->Direction == other.Direction && this->Position == other.Position &&
    this->ConeAngle == other.ConeAngle && this->Attenuation == other.Attenuation;
}

double LightFrame::DepthOfLength() const
{
  return this->Light.Kind == LightKind::Directional
    ? 1 / this->DepthRange
    : 1 / (1 / this->NearestDistance - 1 / this->FarthestDistance);
}

glm::dmat4 LightFrame::WorldToFocus(const Rectangle& focus) const
{
  glm::dmat4 toFocus(1);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = 1 / (focus.High[axis] - focus.Low[axis]);
    toFocus[axis][axis] = scale;
    toFocus[3][axis] = -focus.Low[axis] * scale;
  }
  return toFocus * this->WorldToLight;
}

glm::dvec3 LightFrame::Project(const glm::dvec3& world) const
{
  const glm::dvec4 p = this->WorldToLight * glm::dvec4(world, 1);
  return p.w > 0 ? glm::dvec3(p) / p.w : glm::dvec3(std::numeric_limits<double>::infinity());
}

LightFrame MakeLightFrame(
  const ShadowLight& light, const ExtentFunction& extent, const glm::dvec3& eye, double turn)
{
  LightFrame frame;
  frame.Light = light;
  const Basis basis = BasisOf(light.Direction);
  frame.SAxis = std::cos(turn) * basis.S + std::sin(turn) * basis.T;
  frame.TAxis = std::cos(turn) * basis.T - std::sin(turn) * basis.S;
  if (light.Kind == LightKind::Directional)
  {
    FitDirectional(frame, extent, eye);
  }
  else
  {
    FitSpot(frame, extent, eye);
  }
  return frame;
}

LightFrame Turned(const LightFrame& frame, double by)
{
  const double c = std::cos(by), s = std::sin(by);
  const auto turn = [c, s](const glm::dvec2& v) {
    return glm::dvec2(c * v.x + s * v.y, c * v.y - s * v.x);
  };
  LightFrame turned = frame;
  turned.SAxis = c * frame.SAxis + s * frame.TAxis;
  turned.TAxis = c * frame.TAxis - s * frame.SAxis;
  for (int column = 0; column < 4; ++column)
  {
    const glm::dvec2 rows = turn(glm::dvec2(frame.WorldToLight[column]));
    turned.WorldToLight[column].x = rows.x;
    turned.WorldToLight[column].y = rows.y;
  }
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  const glm::dvec2 middle = turn(0.5 * (frame.Bounds.Low + frame.Bounds.High));
  const double half =
    0.5 * (frame.Bounds.High.x - frame.Bounds.Low.x) * (isSpot ? 1.0 : std::abs(c) + std::abs(s));
  turned.Bounds = { middle - half, middle + half };
  turned.ConeCentre = turn(frame.ConeCentre);
  return turned;
}

double ViewAlignedTurn(
  const ShadowLight& light, const glm::dvec3& eye, const glm::dvec3& forward, double least)
{
  const auto [s, t] = BasisOf(light.Direction);
  glm::dvec2 along(glm::dot(forward, s), glm::dot(forward, t));
  double length = 1;
  if (light.Kind == LightKind::Spot)
  {
    // The derivative of the eye's image, (l · w) / w, as the eye goes forward, times the square of
    // w.
    const glm::dvec3 toEye = eye - light.Position;
    along = along * glm::dot(toEye, light.Direction) -
      glm::dvec2(glm::dot(toEye, s), glm::dot(toEye, t)) * glm::dot(forward, light.Direction);
    length = glm::length(toEye);
  }
  const bool isPoint = !(glm::length(along) > least * length);
  return isPoint ? 0.0 : std::atan2(-along.x, along.y);
}
}
