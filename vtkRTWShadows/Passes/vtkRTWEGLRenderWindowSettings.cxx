// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkRTWEGLRenderWindow that is set and asked; the context's life is in the other file.
#include "Passes/rtwEGLRenderWindowInternals.h"

#include "vtkObjectFactory.h"

#include <string>

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
  return this->QueryOpenGLVersion()[0];
}

int vtkRTWEGLRenderWindow::GetOpenGLMinorVersion()
{
  return this->QueryOpenGLVersion()[1];
}

std::array<int, 2> vtkRTWEGLRenderWindow::QueryOpenGLVersion()
{
  const vtkInternals::Use use(*this->Internals);
  std::array<int, 2> version = { 0, 0 };
  if (this->EnsureInitialized(true))
  {
    this->GetOpenGLVersion(version[0], version[1]);
  }
  return version;
}

bool vtkRTWEGLRenderWindow::HasContext()
{
  return this->Internals->Context != nullptr;
}

int vtkRTWEGLRenderWindow::SupportsOpenGL()
{
  const vtkInternals::Use use(*this->Internals);
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
  const vtkInternals::Use use(*this->Internals);
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
