// SPDX-License-Identifier: BSD-3-Clause
#include "rtwRotatedScene.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace rtw
{
Scene RotatedAboutLight(const Scene& scene, double degrees)
{
  const glm::dvec3 centre = scene.Light.IsSpot ? scene.Light.Position : glm::dvec3(0);
  glm::dmat4 turn = glm::translate(glm::dmat4(1), centre);
  turn = glm::rotate(turn, glm::radians(degrees), scene.Light.Direction);
  turn = glm::translate(turn, -centre);
  const auto place = [&turn](const glm::dvec3& p) { return glm::dvec3(turn * glm::dvec4(p, 1)); };
  Scene rotated = scene;
  rotated.Mesh = vtkSmartPointer<vtkPolyData>::New();
  rotated.Mesh->ShallowCopy(scene.Mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (vtkIdType i = 0; i < scene.Mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    scene.Mesh->GetPoint(i, &p.x);
    p = place(p);
    points->InsertNextPoint(&p.x);
  }
  rotated.Mesh->SetPoints(points);
  for (ScenePart& part : rotated.Parts)
  {
    part.Placement = turn * part.Placement;
  }
  rotated.Camera.Position = place(scene.Camera.Position);
  rotated.Camera.Focal = place(scene.Camera.Focal);
  rotated.Camera.Up = glm::dvec3(turn * glm::dvec4(scene.Camera.Up, 0));
  return rotated;
}
}
