// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCollect.h"

#include "rtwViewRays.h"

#include <vtkActor.h>
#include <vtkAssemblyNode.h>
#include <vtkAssemblyPath.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkGlyph3DMapper.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace rtw
{
namespace
{
Placement Place(vtkMatrix4x4* matrix, const dvec3& origin)
{
  Placement placement;
  placement.Offset = -origin;
  if (matrix)
  {
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        placement.Linear[column][row] = matrix->GetElement(row, column);
      }
      placement.Offset[row] += matrix->GetElement(row, 3);
    }
  }
  return placement;
}

std::vector<glm::dvec4> ClippingPlanes(vtkMapper* mapper, const dvec3& origin)
{
  std::vector<glm::dvec4> planes;
  vtkPlaneCollection* collection = mapper->GetClippingPlanes();
  for (int i = 0; collection && i < collection->GetNumberOfItems(); ++i)
  {
    auto* plane = vtkPlane::SafeDownCast(collection->GetItemAsObject(i));
    dvec3 normal, point;
    plane->GetNormal(&normal.x);
    plane->GetOrigin(&point.x);
    planes.emplace_back(normal, -glm::dot(normal, point - origin));
  }
  return planes;
}

bool Holds(const std::function<bool(vtkProp*)>& predicate, vtkProp* prop, vtkProp* part)
{
  return !predicate || (predicate(prop) && (part == prop || predicate(part)));
}

// One actor, which is `prop` or a part of it.
void AddActor(vtkActor* actor, vtkProp* prop, vtkMatrix4x4* matrix, const ReferenceOptions& options,
  Geometry& to)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  if (!actor->GetVisibility() || !mapper || property->GetRepresentation() != VTK_SURFACE)
  {
    return;
  }
  mapper->Update();
  PropTraits traits;
  traits.IsSeen = actor->HasOpaqueGeometry();
  traits.Casts = Holds(options.Casts, prop, actor);
  traits.Receives = Holds(options.Receives, prop, actor);
  traits.CullsFront = property->GetFrontfaceCulling();
  traits.CullsBack = property->GetBackfaceCulling();
  traits.ClippingPlanes = ClippingPlanes(mapper, to.Origin);
  const uint32_t index = uint32_t(to.Props.size());
  to.Props.push_back(traits);

  const Placement placement = Place(matrix, to.Origin);
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    AddGlyphs(glyphs, placement, index, to);
  }
  else if (!AddImposters(mapper, placement, index, to))
  {
    for (vtkPolyData* surface : Surfaces(mapper))
    {
      AddSurface(surface, placement, index, to);
    }
  }
}

void AddProp(vtkProp* prop, const ReferenceOptions& options, Geometry& to)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    if (auto* actor = vtkActor::SafeDownCast(node->GetViewProp()))
    {
      AddActor(actor, prop, node->GetMatrix(), options, to);
    }
  }
}
}

Geometry Collect(vtkRenderer* renderer, const ReferenceOptions& options)
{
  Geometry geometry;
  geometry.Origin = EyePosition(renderer->GetActiveCamera());
  vtkPropCollection* props = renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
    if (prop->GetVisibility())
    {
      AddProp(prop, options, geometry);
    }
  }
  return geometry;
}

void AddSurface(vtkPolyData* surface, const Placement& placement, uint32_t prop, Geometry& to)
{
  const uint32_t first = uint32_t(to.Points.size());
  const vtkIdType points = surface->GetNumberOfPoints();
  to.Points.reserve(to.Points.size() + size_t(points));
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    to.Points.push_back(placement(p));
  }
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    to.Triangles.push_back({ first + glm::uvec3(a, b, c), prop });
  };

  vtkIdType size;
  const vtkIdType* ids;
  auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, ids);
    for (vtkIdType k = 2; k < size; ++k) // a fan, as VTK draws polygons
    {
      add(ids[0], ids[k - 1], ids[k]);
    }
  }
  cells.TakeReference(surface->GetStrips()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(size, ids);
    for (vtkIdType k = 2; k < size; ++k)
    {
      add(ids[k % 2 ? k - 1 : k - 2], ids[k % 2 ? k - 2 : k - 1], ids[k]);
    }
  }
}
}
