#include "rtwStateGuard.h"

#include "rtwOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

namespace rtw
{
StateGuard::StateGuard(vtkOpenGLRenderWindow* window)
  : Window(window)
  , State(window->GetState())
{
  this->State->Push();
  window->GetShaderCache()->ReleaseCurrentShader();
}

StateGuard::~StateGuard()
{
  // VTK keeps no record of these.
  glUseProgram(0);
  glBindVertexArray(0);
  glDisable(GL_DEPTH_CLAMP);
  glFrontFace(GL_CCW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  // Its record of the rest has to be true before the saved state is compared with it.
  this->State->Reset();
  this->State->Pop();
}

void StateGuard::DrawWithVTK(const std::function<void()>& draw)
{
  glUseProgram(0);
  glBindVertexArray(0);
  this->State->Reset();
  draw();
  this->Window->GetShaderCache()->ReleaseCurrentShader();
}

void StateGuard::PrepareDepthDrawing(bool depthClamp)
{
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (depthClamp)
  {
    glEnable(GL_DEPTH_CLAMP);
  }
  else
  {
    glDisable(GL_DEPTH_CLAMP);
  }
}
}
