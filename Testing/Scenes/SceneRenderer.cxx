// SPDX-License-Identifier: BSD-3-Clause
#include "rtwSceneParts.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <glm/glm.hpp>

#include <algorithm>

namespace rtw
{
namespace
{
// The triangles from `begin` to before `end`, with the points that they use.
vtkSmartPointer<vtkPolyData> Piece(vtkPolyData* mesh, vtkIdType begin, vtkIdType end)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(end - begin, 3 * (end - begin));
  std::vector<vtkIdType> renumbered(mesh->GetNumberOfPoints(), -1);
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    mesh->GetPolys()->GetCellAtId(cell, size, corners);
    cells->InsertNextCell(int(size));
    for (vtkIdType k = 0; k < size; ++k)
    {
      vtkIdType& id = renumbered[corners[k]];
      if (id < 0)
      {
        id = points->InsertNextPoint(mesh->GetPoints()->GetPoint(corners[k]));
      }
      cells->InsertCellPoint(id);
    }
  }
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  piece->SetPoints(points);
  piece->SetPolys(cells);
  return piece;
}

void AddActor(vtkSmartPointer<vtkPolyData> mesh, vtkRenderer* renderer)
{
  ScenePart part;
  part.Data = mesh;
  renderer->AddActor(MakeActor(part));
}
}

void Apply(const SceneCamera& from, vtkCamera* to)
{
  to->SetPosition(from.Position.x, from.Position.y, from.Position.z);
  to->SetFocalPoint(from.Focal.x, from.Focal.y, from.Focal.z);
  to->SetViewUp(from.Up.x, from.Up.y, from.Up.z);
  to->SetViewAngle(from.Angle);
  to->SetClippingRange(from.Near, from.Far);
}

void Apply(const SceneLight& from, const Scene& scene, vtkLight* to)
{
  glm::dvec3 position = from.Position, focal = position + from.Direction;
  if (!from.IsSpot)
  {
    const SceneBounds bounds = BoundsOf(scene);
    focal = (bounds.Low + bounds.High) / 2.0;
    position = focal - from.Direction * glm::distance(bounds.Low, bounds.High);
  }
  to->SetLightTypeToSceneLight();
  to->SetPositional(from.IsSpot);
  to->SetConeAngle(from.IsSpot ? from.Cone : 30);
  to->SetPosition(position.x, position.y, position.z);
  to->SetFocalPoint(focal.x, focal.y, focal.z);
}

vtkSmartPointer<vtkLight> MakeLight(const Scene& scene)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  Apply(scene.Light, scene, light);
  return light;
}

void AddToRenderer(const Scene& scene, vtkRenderer* renderer, int pieces)
{
  const vtkIdType triangles = scene.Mesh->GetNumberOfPolys();
  const vtkIdType actors = std::clamp<vtkIdType>(pieces, 1, std::max<vtkIdType>(triangles, 1));
  for (vtkIdType i = 0; i < actors && triangles > 0; ++i)
  {
    AddActor(actors == 1 ? scene.Mesh
                         : Piece(scene.Mesh, triangles * i / actors, triangles * (i + 1) / actors),
      renderer);
  }
  for (const ScenePart& part : scene.Parts)
  {
    renderer->AddActor(MakeActor(part));
  }
  Apply(scene.Camera, renderer->GetActiveCamera());
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  renderer->AddLight(MakeLight(scene));
  renderer->SetBackground(0.55, 0.65, 0.78);
}
}
