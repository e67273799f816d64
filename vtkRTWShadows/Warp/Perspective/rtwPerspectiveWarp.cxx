// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtw
{
namespace
{
// FOCUS_LINE of rtwBuildPerspective.glsl.
constexpr double FocusLine = 0.8;
constexpr double Strongest = 1e4;

// 1 / n' by Lloyd et al. 2006, equation 11, so that an infinite n' is a number here.
double InverseOfEta(double eta, double n, double f)
{
  const double root = std::sqrt(f / n);
  return eta > 0 ? (1 + eta * root) / (n * (1 + root))
                 : (1 + eta) / (n * (1 + root) * (1 - eta * (root - 1)));
}

double InverseOfFocusPoint(double share, double n, double f)
{
  return (FocusLine - share) / ((1 - FocusLine) * share * (f - n));
}
}

double InverseOfNear(const PerspectiveChoice& choice, double n, double f)
{
  const double inverse = choice.Kind == PerspectiveChoice::Eta ? InverseOfEta(choice.Value, n, f)
    : choice.Kind == PerspectiveChoice::Near                   ? 1 / choice.Value
                                             : InverseOfFocusPoint(choice.Value, n, f);
  return std::clamp(inverse, 0.0, 1 / n);
}

double NearOfEta(double eta, double n, double f)
{
  return 1 / InverseOfNear({ PerspectiveChoice::Eta, eta }, n, f);
}

double EtaOfNear(double nearDistance, double n, double f)
{
  // M_z of LiSPSM is 1 / √α of what it is with no warp, and with η = 1.
  const double a = f / n, m = nearDistance / n, root = std::sqrt(a);
  if (m >= root + 1)
  {
    const double error = std::isinf(m) ? 1 : m / (m + a - 1);
    return (1 / root - error) / (1 - 1 / root);
  }
  const double error = (m + a - 1) / (m * a);
  return (error - 1 / root) / (1 - 1 / root);
}

double NearOfFocusPoint(double share, double n, double f)
{
  return 1 / InverseOfNear({ PerspectiveChoice::FocusPoint, share }, n, f);
}

ViewOnLight LookAtView(
  const LightFrame& frame, const glm::dvec3& eye, const glm::dvec3& forward, bool parallel)
{
  const glm::dvec3& direction = frame.Light.Direction;
  ViewOnLight view;
  if (parallel)
  {
    return view;
  }
  if (frame.Light.Kind == LightKind::Directional)
  {
    view.Sine = glm::length(glm::cross(forward, direction));
    view.Unit = 1;
    return view;
  }
  const glm::dvec3 toEye = eye - frame.Light.Position;
  const double along = glm::dot(toEye, direction);
  if (!(along > 0))
  {
    return view;
  }
  view.Sine =
    glm::length(forward * along - toEye * glm::dot(forward, direction)) / glm::length(toEye);
  view.Unit = along;
  view.EyeS = frame.Project(eye).x;
  return view;
}

double PerspectiveStrength(
  const PerspectiveChoice& choice, const ViewOnLight& view, double nearest, double extent)
{
  if (!(view.Unit > 0) || !(view.Sine > 0) || !(nearest > 0) || !(extent > 0))
  {
    return 0;
  }
  const double depth = extent * view.Unit / view.Sine;
  return std::clamp(view.Sine * view.Sine * depth * InverseOfNear(choice, nearest, nearest + depth),
    0.0, Strongest);
}

glm::dvec2 PerspectiveWarp::Forward(const glm::dvec2& onLight) const
{
  const glm::dvec2 q = (onLight - this->Focus.Low) / (this->Focus.High - this->Focus.Low);
  const double h = 1 + this->Strength * q.y;
  if (!(h > 0))
  {
    return glm::dvec2(std::numeric_limits<double>::quiet_NaN());
  }
  const double column = this->EyeS + (q.x - this->EyeS) / h;
  return { (column - this->Ends.x) / (this->Ends.y - this->Ends.x),
    (1 + this->Strength) * q.y / h };
}

glm::dvec2 PerspectiveWarp::Inverse(const glm::dvec2& onMap) const
{
  const double scale = 1 / (1 + this->Strength * (1 - onMap.y));
  const double column = this->Ends.x + onMap.x * (this->Ends.y - this->Ends.x);
  const glm::dvec2 q(
    this->EyeS + (1 + this->Strength) * scale * (column - this->EyeS), onMap.y * scale);
  return this->Focus.Low + q * (this->Focus.High - this->Focus.Low);
}
}
