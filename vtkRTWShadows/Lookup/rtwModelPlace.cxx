// SPDX-License-Identifier: BSD-3-Clause
#include "Lookup/rtwModelPlace.h"

#include "Frame/rtwView.h"

#include "vtkMatrix4x4.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProp3D.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

namespace rtw
{
namespace
{
// The matrix that undoes a mapper's shift and scale: VTK shifts and scales points that lie far from
// their origin.
glm::dmat4 StoredToModel(vtkAbstractMapper* mapper)
{
  auto* drawn = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  vtkOpenGLVertexBufferObject* points = drawn ? drawn->GetVBOs()->GetVBO("vertexMC") : nullptr;
  if (!points || !points->GetCoordShiftAndScaleEnabled())
  {
    return glm::dmat4(1);
  }
  const auto& shift = points->GetShift();
  const auto& scale = points->GetScale();
  glm::dmat4 toModel(1);
  for (int axis = 0; axis < 3; ++axis)
  {
    toModel[axis][axis] = 1 / scale[axis];
    toModel[3][axis] = shift[axis];
  }
  return toModel;
}
}

void SetModelToView(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, const View& view)
{
  if (!program->IsUniformUsed("rtwModelToView"))
  {
    return;
  }
  glm::dmat4 toView = view.WorldToView;
  if (auto* placed = vtkProp3D::SafeDownCast(prop))
  {
    placed->ComputeMatrix();
    toView = toView * ToGlm(placed->vtkProp3D::GetMatrix());
  }
  glm::mat4 result(toView * StoredToModel(mapper));
  program->SetUniformMatrix4x4v("rtwModelToView", 1, glm::value_ptr(result));
}
}
