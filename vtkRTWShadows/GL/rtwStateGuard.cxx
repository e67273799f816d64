#include "GL/rtwStateGuard.h"

#include "GL/rtwOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"

namespace rtw
{
StateGuard::DrawObjects StateGuard::DrawObjects::Bound()
{
  GLint program = 0, vertices = 0, buffer = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertices);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer);
  return { static_cast<GLuint>(program), static_cast<GLuint>(vertices),
    static_cast<GLuint>(buffer) };
}

void StateGuard::DrawObjects::Bind() const
{
  glUseProgram(this->Program && glIsProgram(this->Program) ? this->Program : 0);
  glBindVertexArray(
    this->Vertices && glIsVertexArray(this->Vertices) ? this->Vertices : 0);
  glBindBuffer(
    GL_ARRAY_BUFFER, this->ArrayBuffer && glIsBuffer(this->ArrayBuffer) ? this->ArrayBuffer : 0);
}

StateGuard::StateGuard(vtkOpenGLRenderWindow* window)
  : Window(window)
  , State(window->GetState())
  , Before(DrawObjects::Bound())
  , Taking(&this->Changed)
{
  this->Unbind();
  // What VTK pops later has to be what is there now, whoever made it.
  this->State->Reset();
  this->State->Push();
}

StateGuard::~StateGuard()
{
  this->Changed.GiveBack();
  this->State->Pop();
  this->Before.Bind();
}

void StateGuard::Unbind()
{
  this->Window->GetShaderCache()->ReleaseCurrentShader();
  glUseProgram(0);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void StateGuard::DrawWithVTK(const std::function<void()>& draw)
{
  this->Changed.GiveBackBindings();
  this->Unbind();
  this->State->Reset();
  {
    const StateRecord::Scope untaken(nullptr);
    draw();
  }
  this->Unbind();
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
  SetEnabled(GL_DEPTH_CLAMP, depthClamp);
}
}
