// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRTWEGLRenderWindow.h"

#include "rtwEGLContext.h"
#include "rtwOpenGL.h"

#include "vtkCollection.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkRTWEGLRenderWindow);

struct vtkRTWEGLRenderWindow::vtkInternals
{
  std::unique_ptr<rtwEGLContext> Context;

  // The request that failed last, so that it is not tried again at each frame and told but once.
  rtwEGLContext::Request FailedRequest;
  std::string WhyNot;
  bool Reported = false;

  // While resources are released, MakeCurrent must not bring a context to life.
  bool Releasing = false;

  // Whether Start() got as far as to push the framebuffer bindings that End() pops.
  bool Started = false;

  std::string Capabilities;
};

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

void vtkRTWEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeviceIndex: " << this->DeviceIndex << "\n";
  os << indent << "CurrentDeviceIndex: " << this->GetCurrentDeviceIndex() << "\n";
  os << indent << "MaximumOpenGLVersion: " << this->MaximumOpenGLMajorVersion << "."
     << this->MaximumOpenGLMinorVersion << "\n";
  os << indent << "HasContext: " << (this->HasContext() ? "yes" : "no") << "\n";
  if (!this->Internals->WhyNot.empty())
  {
    os << indent << "WhyNoContext: " << this->Internals->WhyNot << "\n";
  }
}

void vtkRTWEGLRenderWindow::SetDeviceIndex(int index)
{
  this->Superclass::SetDeviceIndex(index < -1 ? -1 : index);
}

int vtkRTWEGLRenderWindow::GetNumberOfDevices()
{
  return rtwEGLContext::GetNumberOfDevices();
}

int vtkRTWEGLRenderWindow::GetCurrentDeviceIndex()
{
  return this->HasContext() ? this->Internals->Context->GetDeviceIndex() : -1;
}

void vtkRTWEGLRenderWindow::SetMaximumOpenGLVersion(int major, int minor)
{
  const bool exists =
    (major == 3 && minor >= 2 && minor <= 3) || (major == 4 && minor >= 0 && minor <= 6);
  if (!exists)
  {
    vtkErrorMacro("MaximumOpenGLVersion is "
      << major << "." << minor << ", but must be 3.2, 3.3 or 4.0 to 4.6; it stays "
      << this->MaximumOpenGLMajorVersion << "." << this->MaximumOpenGLMinorVersion << ".");
    return;
  }
  if (this->MaximumOpenGLMajorVersion != major || this->MaximumOpenGLMinorVersion != minor)
  {
    this->MaximumOpenGLMajorVersion = major;
    this->MaximumOpenGLMinorVersion = minor;
    this->Modified();
  }
}

int vtkRTWEGLRenderWindow::GetOpenGLMajorVersion()
{
  int major = 0;
  int minor = 0;
  if (this->EnsureInitialized(true))
  {
    this->GetOpenGLVersion(major, minor);
  }
  return major;
}

int vtkRTWEGLRenderWindow::GetOpenGLMinorVersion()
{
  int major = 0;
  int minor = 0;
  if (this->EnsureInitialized(true))
  {
    this->GetOpenGLVersion(major, minor);
  }
  return minor;
}

bool vtkRTWEGLRenderWindow::HasContext()
{
  return this->Internals->Context != nullptr;
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
  if (!this->EnsureContext(report))
  {
    return false;
  }
  this->MakeCurrent();
  if (!this->IsCurrent())
  {
    return false;
  }
  if (!this->Initialized)
  {
    this->OpenGLInit();
  }
  return this->Initialized;
}

void vtkRTWEGLRenderWindow::MakeCurrent()
{
  vtkInternals& self = *this->Internals;
  if (!this->EnsureContext(true))
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
                      "thread has it, or this thread has a context of another API (GLX) current, "
                      "which must be released first.");
      }
      return;
  }
}

void vtkRTWEGLRenderWindow::ForgetLostContext()
{
  vtkWarningMacro("The driver lost the OpenGL context; the next Render() makes a new one.");
  this->Internals->Context.reset();
  this->Finalize();
}

bool vtkRTWEGLRenderWindow::IsCurrent()
{
  return this->Internals->Context && this->Internals->Context->IsCurrent();
}

void vtkRTWEGLRenderWindow::PushContext()
{
  this->MakeCurrent();
}

void vtkRTWEGLRenderWindow::PopContext() {}

void vtkRTWEGLRenderWindow::Finalize()
{
  vtkInternals& self = *this->Internals;
  if (self.Releasing)
  {
    return;
  }
  if (self.Context)
  {
    self.Context->MakeCurrent();
  }
  self.Releasing = true;
  if (this->Initialized)
  {
    this->ReleaseGraphicsResources(this);
  }
  self.Context.reset();
  self.Releasing = false;
  self.Started = false;
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
  this->EnsureInitialized(true);
}

void vtkRTWEGLRenderWindow::Start()
{
  if (this->EnsureInitialized(true))
  {
    this->Superclass::Start();
    this->Internals->Started = true;
  }
}

void vtkRTWEGLRenderWindow::End()
{
  if (this->Internals->Started)
  {
    this->Internals->Started = false;
    this->Superclass::End();
  }
}

void vtkRTWEGLRenderWindow::Render()
{
  if (this->EnsureInitialized(true))
  {
    this->Superclass::Render();
  }
}

int vtkRTWEGLRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  if (!this->Initialized)
  {
    vtkWarningMacro("Nothing has been rendered yet, so there are no pixels to read.");
    return VTK_ERROR;
  }
  return this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right);
}

int vtkRTWEGLRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  if (!this->Initialized)
  {
    vtkWarningMacro("Nothing has been rendered yet, so there is no depth to read.");
    return VTK_ERROR;
  }
  return this->Superclass::GetZbufferData(x1, y1, x2, y2, z);
}

//------------------------------------------------------------------------------
// Questions

int vtkRTWEGLRenderWindow::SupportsOpenGL()
{
  const bool works = this->EnsureInitialized(false);
  this->OpenGLSupportTested = true;
  this->OpenGLSupportResult = works ? 1 : 0;
  this->OpenGLSupportMessage =
    works ? std::string("OpenGL works, by EGL") : "No OpenGL by EGL: " + this->Internals->WhyNot;
  return this->OpenGLSupportResult;
}

vtkTypeBool vtkRTWEGLRenderWindow::IsDirect()
{
  return this->HasContext() ? 1 : 0;
}

const char* vtkRTWEGLRenderWindow::ReportCapabilities()
{
  if (this->EnsureInitialized(false))
  {
    return this->Superclass::ReportCapabilities();
  }
  this->Internals->Capabilities = "No OpenGL context: " + this->Internals->WhyNot + "\n";
  return this->Internals->Capabilities.c_str();
}

void* vtkRTWEGLRenderWindow::GetGenericContext()
{
  return this->HasContext() ? this->Internals->Context->GetNativeContext() : nullptr;
}

void* vtkRTWEGLRenderWindow::GetGenericDisplayId()
{
  return this->HasContext() ? this->Internals->Context->GetNativeDisplay() : nullptr;
}

void* vtkRTWEGLRenderWindow::GetGenericDrawable()
{
  return this->HasContext() ? this->Internals->Context->GetNativeSurface() : nullptr;
}
