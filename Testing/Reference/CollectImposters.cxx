// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCollect.h"

#include <vtkDataArray.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace rtw
{
namespace
{
// The mappers do not tell the names of their arrays.
struct SphereNames : vtkOpenGLSphereMapper
{
  static const char* Scale(vtkOpenGLSphereMapper* mapper)
  {
    return mapper->*(&SphereNames::ScaleArray);
  }
};

struct StickNames : vtkOpenGLStickMapper
{
  static const char* Scale(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&StickNames::ScaleArray);
  }
  static const char* Orientation(vtkOpenGLStickMapper* mapper)
  {
    return mapper->*(&StickNames::OrientationArray);
  }
};

vtkDataArray* PointArray(vtkPolyData* data, const char* name)
{
  return name ? data->GetPointData()->GetArray(name) : nullptr;
}

// Sizes are in world coordinates, because the mappers do not scale them with the actor.
void AddBalls(
  vtkOpenGLSphereMapper* mapper, const Placement& placement, uint32_t prop, Geometry& to)
{
  for (vtkPolyData* data : Surfaces(mapper))
  {
    vtkDataArray* radii = PointArray(data, SphereNames::Scale(mapper));
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      const double radius = radii ? radii->GetTuple1(i) : mapper->GetRadius();
      to.Balls.push_back({ placement(data->GetPoint(i)), radius, prop });
    }
  }
}

void AddSticks(
  vtkOpenGLStickMapper* mapper, const Placement& placement, uint32_t prop, Geometry& to)
{
  const glm::dmat3 forNormals = glm::transpose(glm::inverse(placement.Linear));
  for (vtkPolyData* data : Surfaces(mapper))
  {
    vtkDataArray* sizes = PointArray(data, StickNames::Scale(mapper));
    vtkDataArray* directions = PointArray(data, StickNames::Orientation(mapper));
    for (vtkIdType i = 0; sizes && directions && i < data->GetNumberOfPoints(); ++i)
    {
      dvec3 size, direction; // length and radius; the third component is not used
      sizes->GetTuple(i, &size.x);
      directions->GetTuple(i, &direction.x);
      const double halfLength = size.x * glm::length(direction) / 2;
      to.Sticks.push_back({ placement(data->GetPoint(i)), glm::normalize(forNormals * direction),
        halfLength, size.y, prop });
    }
  }
}
}

bool AddImposters(vtkMapper* mapper, const Placement& placement, uint32_t prop, Geometry& to)
{
  if (auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper))
  {
    AddBalls(spheres, placement, prop, to);
    return true;
  }
  if (auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper))
  {
    AddSticks(sticks, placement, prop, to);
    return true;
  }
  return false;
}
}
