// SPDX-License-Identifier: BSD-3-Clause
#include "rtwScene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
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

void AddActor(vtkPolyData* mesh, vtkRenderer* renderer)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.86, 0.83, 0.78);
  actor->GetProperty()->SetAmbient(0.12);
  renderer->AddActor(actor);
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

vtkSmartPointer<vtkLight> MakeLight(const Scene& scene)
{
  glm::dvec3 position = scene.Light.Position, focal = position + scene.Light.Direction;
  if (!scene.Light.IsSpot)
  {
    double centre[3];
    scene.Mesh->GetCenter(centre);
    focal = { centre[0], centre[1], centre[2] };
    position = focal - scene.Light.Direction * scene.Mesh->GetLength();
  }
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(scene.Light.IsSpot);
  light->SetConeAngle(scene.Light.IsSpot ? scene.Light.Cone : 30);
  light->SetPosition(position.x, position.y, position.z);
  light->SetFocalPoint(focal.x, focal.y, focal.z);
  return light;
}

void AddToRenderer(const Scene& scene, vtkRenderer* renderer, int pieces)
{
  const vtkIdType triangles = scene.Mesh->GetNumberOfPolys();
  const vtkIdType actors = std::clamp<vtkIdType>(pieces, 1, std::max<vtkIdType>(triangles, 1));
  for (vtkIdType i = 0; i < actors; ++i)
  {
    AddActor(actors == 1
        ? scene.Mesh.Get()
        : Piece(scene.Mesh, triangles * i / actors, triangles * (i + 1) / actors).Get(),
      renderer);
  }
  Apply(scene.Camera, renderer->GetActiveCamera());
  renderer->AutomaticLightCreationOff();
  renderer->RemoveAllLights();
  renderer->AddLight(MakeLight(scene));
  renderer->SetBackground(0.55, 0.65, 0.78);
}
}
