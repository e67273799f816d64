// SPDX-License-Identifier: BSD-3-Clause
#include "rtwView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <cmath>

namespace rtw
{
glm::dmat4 ToGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

bool View::IsUsable() const
{
  if (this->Width < 1 || this->Height < 1)
  {
    return false;
  }
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      if (!std::isfinite(this->ViewToWorld[column][row]) ||
        !std::isfinite(this->ClipToView[column][row]))
      {
        return false;
      }
    }
  }
  return true;
}

View ViewOf(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  View view;
  renderer->GetTiledSizeAndOrigin(&view.Width, &view.Height, &view.OriginX, &view.OriginY);
  if (auto* target = vtkOpenGLFramebufferObject::SafeDownCast(state->GetFrameBuffer()))
  {
    int size[2];
    target->GetLastSize(size);
    view.Width = size[0];
    view.Height = size[1];
    view.OriginX = view.OriginY = 0;
  }
  view.WorldToView = ToGlm(camera->GetModelViewTransformMatrix());
  view.ViewToWorld = glm::inverse(view.WorldToView);
  view.ViewToClip =
    ToGlm(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  view.ClipToView = glm::inverse(view.ViewToClip);
  view.Eye = glm::dvec3(view.ViewToWorld[3]);
  view.Forward = glm::normalize(-glm::dvec3(view.ViewToWorld[2]));
  view.Parallel = camera->GetParallelProjection() != 0;
  return view;
}
}
