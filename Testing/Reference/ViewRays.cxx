// SPDX-License-Identifier: BSD-3-Clause
#include "rtwViewRays.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

namespace rtw
{
namespace
{
glm::dmat4 Convert(vtkMatrix4x4* from)
{
  glm::dmat4 to;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      to[column][row] = from->GetElement(row, column);
    }
  }
  return to;
}
}

dvec3 EyePosition(vtkCamera* camera)
{
  return dvec3(glm::inverse(Convert(camera->GetModelViewTransformMatrix()))[3]);
}

ViewRays::ViewRays(vtkCamera* camera, int width, int height)
  : Width(width)
  , Height(height)
  , ToEye(Convert(camera->GetModelViewTransformMatrix()))
  , Projection(Convert(camera->GetProjectionTransformMatrix(double(width) / double(height), -1, 1)))
{
  this->ToWorld = glm::inverse(this->ToEye);
  this->Unprojection = glm::inverse(this->Projection);
  // The camera's position is mapped to infinity, and not to one side of it.
  const glm::dvec4 centre = this->Projection[3];
  this->HasCentre = centre.x == 0 && centre.y == 0 && centre.w == 0;
}

Ray ViewRays::At(double x, double y) const
{
  const auto unproject = [&](double z) {
    const glm::dvec4 p =
      this->Unprojection * glm::dvec4(2 * x / this->Width - 1, 2 * y / this->Height - 1, z, 1);
    return this->ToWorld * (dvec3(p) / p.w);
  };
  const dvec3 low = unproject(-1), high = unproject(1);
  if (this->HasCentre)
  {
    return { dvec3(0), glm::normalize(high), glm::length(low), glm::length(high) };
  }
  return { low, glm::normalize(high - low), 0, glm::distance(low, high) };
}

double ViewRays::WindowDepth(const dvec3& position) const
{
  const glm::dvec4 p = this->Projection * glm::dvec4(this->ToEye * position, 1);
  return 0.5 * p.z / p.w + 0.5;
}
}
