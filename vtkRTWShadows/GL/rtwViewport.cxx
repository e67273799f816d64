// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwViewport.h"

#include "GL/rtwOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace rtw
{
glm::ivec4 ViewportOf(vtkOpenGLRenderWindow* window)
{
  GLint viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  return { viewport[0], viewport[1], viewport[2], viewport[3] };
}
}
