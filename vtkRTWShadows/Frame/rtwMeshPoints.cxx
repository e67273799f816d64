// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwMeshPoints.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

namespace rtw
{
namespace
{
bool IsFinite(const glm::vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}
}

bool MeshPoints::Exists(vtkIdType id) const
{
  return id >= 0 && id < static_cast<vtkIdType>(this->Points.size()) && IsFinite(this->Points[id]);
}

MeshPoints ReadPoints(vtkPolyData* data)
{
  MeshPoints result;
  double bounds[6];
  data->GetBounds(bounds);
  const glm::dvec3 centre =
    0.5 * glm::dvec3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
  result.Centre = IsFinite(glm::vec3(centre)) ? centre : glm::dvec3(0);
  vtkPoints* points = data->GetPoints();
  result.Points.resize(points->GetNumberOfPoints());
  for (std::size_t i = 0; i < result.Points.size(); ++i)
  {
    double p[3];
    points->GetPoint(static_cast<vtkIdType>(i), p);
    result.Points[i] = glm::vec3(glm::dvec3(p[0], p[1], p[2]) - result.Centre);
  }
  return result;
}
}
