// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRTWEGLRenderWindow.h"

#include "GL/rtwOpenGL.h"
#include "Passes/rtwEGLRenderWindowInternals.h"

#include "vtkCollection.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

vtkStandardNewMacro(vtkRTWEGLRenderWindow);

vtkRTWEGLRenderWindow::vtkRTWEGLRenderWindow()
  : Internals(new vtkInternals)
{
  this->DeviceIndex = -1;
  this->OwnContext = 1;
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  // The picture stays in the window's own framebuffers: the pbuffer is not one to show it in.
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->SetFrameBlitMode(vtkOpenGLRenderWindow::NoBlit);
#if !defined(GLEW_OK)
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) -> vtkOpenGLRenderWindow::VTKOpenGLAPIProc {
      return reinterpret_cast<vtkOpenGLRenderWindow::VTKOpenGLAPIProc>(
        rtwEGLContext::GetFunction(name));
    },
    nullptr);
#endif
}

vtkRTWEGLRenderWindow::~vtkRTWEGLRenderWindow()
{
  this->Finalize();
  // The superclass releases the resources of its renderers once more; by then MakeCurrent is no
  // longer ours, so no renderer may still be with this window.
  this->Internals->Releasing = true;
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    if (renderer->GetRenderWindow() == this)
    {
      renderer->SetRenderWindow(nullptr);
    }
  }
}

//------------------------------------------------------------------------------
// The context's life

bool vtkRTWEGLRenderWindow::EnsureContext(bool report)
{
  vtkInternals& self = *this->Internals;
  if (self.Context)
  {
    return true;
  }
  if (self.Releasing)
  {
    return false;
  }
  const rtwEGLContext::Request request{ this->DeviceIndex, this->MaximumOpenGLMajorVersion,
    this->MaximumOpenGLMinorVersion };
  if (self.WhyNot.empty() || !(request == self.FailedRequest))
  {
    self.WhyNot.clear();
    self.Reported = false;
    self.Context = rtwEGLContext::Create(request, self.WhyNot);
    self.FailedRequest = request;
  }
  if (self.Context)
  {
    self.WhyNot.clear();
    this->Mapped = 1;
    return true;
  }
  if (report && !self.Reported)
  {
    self.Reported = true;
    vtkErrorMacro("No OpenGL context, so nothing is drawn: "
      << self.WhyNot
      << ". Install a GPU driver with EGL or Mesa's software driver (Debian: libegl1 and "
         "libgl1-mesa-dri), or choose another DeviceIndex.");
  }
  return false;
}

bool vtkRTWEGLRenderWindow::EnsureInitialized(bool report)
{
  // The second attempt is for a context that the first finds lost.
  for (int attempt = 0; attempt < 2 && !this->IsCurrent(); ++attempt)
  {
    if (!this->EnsureContext(report))
    {
      return false;
    }
    this->MakeCurrent();
  }
  if (this->IsCurrent() && !this->Initialized)
  {
    this->OpenGLInit();
  }
  return this->IsCurrent() && this->Initialized;
}

void vtkRTWEGLRenderWindow::MakeCurrent()
{
  vtkInternals& self = *this->Internals;
  if (self.Releasing || !this->EnsureContext(true))
  {
    return;
  }
  switch (self.Context->MakeCurrent())
  {
    case rtwEGLContext::Status::Current:
      self.Reported = false;
      return;
    case rtwEGLContext::Status::Lost:
      this->ForgetLostContext();
      return;
    case rtwEGLContext::Status::Failed:
      if (!self.Reported)
      {
        self.Reported = true;
        vtkErrorMacro("The OpenGL context cannot be made current, so nothing is drawn: another "
                      "thread has it. Call ReleaseCurrent() there first.");
      }
      return;
  }
}

void vtkRTWEGLRenderWindow::ForgetLostContext()
{
  vtkWarningMacro("The OpenGL context is lost, by a reset of the driver or by an eglTerminate of "
                  "other code; a new one is made when next needed.");
  this->Finalize();
}

bool vtkRTWEGLRenderWindow::IsCurrent()
{
  return this->Internals->Context && this->Internals->Context->IsCurrent();
}

void vtkRTWEGLRenderWindow::PushContext()
{
  this->Internals->BeginUse();
  if (this->HasContext()) // else there is nothing to be used or released in one
  {
    this->MakeCurrent();
  }
}

void vtkRTWEGLRenderWindow::PopContext()
{
  this->Internals->EndUse();
}

void vtkRTWEGLRenderWindow::ReleaseCurrent()
{
  if (this->IsCurrent())
  {
    this->Internals->Context->ReleaseCurrent();
    this->Internals->Context->GiveBack();
  }
}

void vtkRTWEGLRenderWindow::Finalize()
{
  vtkInternals& self = *this->Internals;
  if (self.Releasing)
  {
    return;
  }
  if (self.Context && self.Context->MakeCurrent() != rtwEGLContext::Status::Current)
  {
    // The resources went with the context, and none of the same name may be deleted in another.
    self.Context->ReleaseCurrent();
  }
  self.Releasing = true;
  if (this->Initialized)
  {
    this->ReleaseGraphicsResources(this);
  }
  self.Context.reset();
  self.Releasing = false;
  if (self.Started)
  {
    self.Started = false;
    self.EndUse();
  }
  this->Mapped = 0;
}

//------------------------------------------------------------------------------
// The OpenGL functions

void vtkRTWEGLRenderWindow::OpenGLInit()
{
  if (!this->EnsureContext(true))
  {
    return;
  }
  this->MakeCurrent();
  // The superclass looks at the OpenGL state before it loads the functions.
  this->OpenGLInitContext();
  if (this->Initialized)
  {
    this->Superclass::OpenGLInit();
  }
}

void vtkRTWEGLRenderWindow::OpenGLInitContext()
{
#if defined(GLEW_OK)
  if (this->Initialized)
  {
    return;
  }
  // GLEW loads all OpenGL functions and only then fails, for want of an X display, to load those
  // of GLX, which VTK's own code takes for the whole failing.
  this->ContextCreationTime.Modified();
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  this->GlewInitValid = (result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY);
  if (!this->GlewInitValid)
  {
    vtkErrorMacro("The OpenGL functions could not be loaded: " << glewGetErrorString(result));
    return;
  }
  this->Initialized = true;
  GLfloat range[2] = { 1.0f, 1.0f };
  glGetFloatv(
    this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = glGetError() == GL_NO_ERROR ? range[1] : 1.0f;
#else
  this->Superclass::OpenGLInitContext();
#endif
}

//------------------------------------------------------------------------------
// Drawing and reading: as in the superclass, but for the case that there is no context

void vtkRTWEGLRenderWindow::Initialize()
{
  const vtkInternals::Use use(*this->Internals);
  this->EnsureInitialized(true);
}

void vtkRTWEGLRenderWindow::Start()
{
  if (this->EnsureInitialized(true))
  {
    if (!this->Internals->Started)
    {
      this->Internals->Started = true;
      this->Internals->BeginUse();
    }
    this->Superclass::Start();
  }
}

void vtkRTWEGLRenderWindow::End()
{
  if (this->Internals->Started)
  {
    this->Internals->Started = false;
    this->Superclass::End();
    this->Internals->EndUse();
  }
}

void vtkRTWEGLRenderWindow::Render()
{
  const vtkInternals::Use use(*this->Internals);
  if (this->EnsureInitialized(true))
  {
    this->Superclass::Render();
  }
}

bool vtkRTWEGLRenderWindow::HasPicture()
{
  if (this->HasContext())
  {
    this->MakeCurrent();
  }
  if (this->IsCurrent() && this->Initialized)
  {
    return true;
  }
  vtkWarningMacro("Nothing is rendered, so there are no pixels to read. Call Render() first.");
  return false;
}

int vtkRTWEGLRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  const vtkInternals::Use use(*this->Internals);
  return this->HasPicture()
    ? this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right)
    : VTK_ERROR;
}

int vtkRTWEGLRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  const vtkInternals::Use use(*this->Internals);
  return this->HasPicture() ? this->Superclass::GetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}
