// SPDX-License-Identifier: BSD-3-Clause
#include "rtwSceneParts.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkOpenGLStickMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <glm/glm.hpp>

namespace rtw
{
namespace
{
vtkSmartPointer<vtkMapper> MakeMapper(const ScenePart& part)
{
  switch (part.Kind)
  {
    case PartKind::GLYPHS:
    {
      auto glyphs = vtkSmartPointer<vtkGlyph3DMapper>::New();
      glyphs->SetInputData(part.Data);
      glyphs->SetSourceData(part.Glyph);
      glyphs->SetScaleArray(RADIUS_ARRAY);
      glyphs->SetScaleModeToScaleByMagnitude();
      glyphs->ScalarVisibilityOff();
      return glyphs;
    }
    case PartKind::SPHERES:
    {
      auto spheres = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
      spheres->SetInputData(part.Data);
      spheres->SetScaleArray(RADIUS_ARRAY);
      return spheres;
    }
    case PartKind::STICKS:
    {
      auto sticks = vtkSmartPointer<vtkOpenGLStickMapper>::New();
      sticks->SetInputData(part.Data);
      sticks->SetScaleArray(SIZE_ARRAY);
      sticks->SetOrientationArray(AXIS_ARRAY);
      return sticks;
    }
    default:
    {
      auto surface = vtkSmartPointer<vtkPolyDataMapper>::New();
      surface->SetInputData(part.Data);
      return surface;
    }
  }
}

// How far what is drawn for a point reaches from it.
double Reach(const ScenePart& part)
{
  double reach = 0;
  for (const char* name : { RADIUS_ARRAY, SIZE_ARRAY })
  {
    if (vtkDataArray* sizes = part.Data->GetPointData()->GetArray(name))
    {
      double range[2];
      sizes->GetRange(range, -1); // of magnitudes
      reach = std::max(reach, range[1]);
    }
  }
  return part.Kind == PartKind::GLYPHS ? reach * part.Glyph->GetLength() / 2 : reach;
}

void Include(const glm::dvec3& p, SceneBounds& bounds)
{
  bounds.Low = glm::min(bounds.Low, p);
  bounds.High = glm::max(bounds.High, p);
}

void Include(vtkPolyData* data, const glm::dmat4& placement, double reach, SceneBounds& to)
{
  if (data->GetNumberOfPoints() > 0)
  {
    double bounds[6];
    data->GetBounds(bounds);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec4 p(
        bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)], 1);
      const glm::dvec3 placed(placement * p);
      Include(placed - reach, to);
      Include(placed + reach, to);
    }
  }
}
}

vtkSmartPointer<vtkActor> MakeActor(const ScenePart& part)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(MakeMapper(part));
  actor->GetProperty()->SetColor(part.Colour.x, part.Colour.y, part.Colour.z);
  actor->GetProperty()->SetAmbient(part.Ambient);
  if (part.Placement != glm::dmat4(1))
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        matrix->SetElement(row, column, part.Placement[column][row]);
      }
    }
    actor->SetUserMatrix(matrix);
  }
  return actor;
}

std::size_t NumberOfTriangles(const Scene& scene)
{
  vtkIdType triangles = scene.Mesh->GetNumberOfPolys();
  for (const ScenePart& part : scene.Parts)
  {
    const vtkIdType points = part.Data->GetNumberOfPoints();
    triangles += part.Kind == PartKind::SURFACE ? part.Data->GetNumberOfPolys()
      : part.Kind == PartKind::GLYPHS           ? points * part.Glyph->GetNumberOfPolys()
      : part.Kind == PartKind::STICKS           ? points * 12
                                                : points;
  }
  return std::size_t(triangles);
}

SceneBounds BoundsOf(const Scene& scene)
{
  SceneBounds bounds{ glm::dvec3(VTK_DOUBLE_MAX), glm::dvec3(-VTK_DOUBLE_MAX) };
  Include(scene.Mesh, glm::dmat4(1), 0, bounds);
  for (const ScenePart& part : scene.Parts)
  {
    Include(part.Data, part.Placement, part.Kind == PartKind::SURFACE ? 0 : Reach(part), bounds);
  }
  return bounds;
}
}
