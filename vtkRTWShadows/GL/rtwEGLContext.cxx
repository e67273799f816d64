// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwEGLContext.h"

#include "GL/rtwGLXContext.h"

rtwEGLContext::rtwEGLContext() = default;

#if RTW_HAVE_EGL

#define EGL_NO_X11 // else the headers bring in Xlib and its macros
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <utility>
#include <vector>

namespace
{
#ifndef EGL_PLATFORM_SURFACELESS_MESA
constexpr EGLenum EGL_PLATFORM_SURFACELESS_MESA = 0x31DD;
#endif

// The versions of desktop OpenGL that have a core profile and that VTK can use, best first.
constexpr int Versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 }, { 4, 1 },
  { 4, 0 }, { 3, 3 }, { 3, 2 } };

// An extension is a whole word of the list, not just a part of one.
bool HasExtension(EGLDisplay display, const char* name)
{
  const char* list = eglQueryString(display, EGL_EXTENSIONS);
  const size_t length = std::strlen(name);
  for (const char* at = list; at && (at = std::strstr(at, name)); at += length)
  {
    if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
    {
      return true;
    }
  }
  return false;
}

template <typename Function>
Function GetExtensionFunction(const char* name)
{
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> GetDevices()
{
  if (!HasExtension(EGL_NO_DISPLAY, "EGL_EXT_device_base") &&
    !HasExtension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration"))
  {
    return {};
  }
  const auto query = GetExtensionFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!query || !query(0, nullptr, &count) || count <= 0)
  {
    return {};
  }
  std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
  if (!query(count, devices.data(), &count))
  {
    return {};
  }
  devices.resize(static_cast<size_t>(count));
  return devices;
}

EGLDisplay GetPlatformDisplay(EGLenum platform, const char* extension, void* native)
{
  const auto get =
    GetExtensionFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!get || !HasExtension(EGL_NO_DISPLAY, extension))
  {
    return EGL_NO_DISPLAY;
  }
  return get(platform, native, nullptr);
}

EGLConfig ChooseConfig(EGLDisplay display, EGLint surfaceType)
{
  const EGLint attributes[] = { EGL_SURFACE_TYPE, surfaceType, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24,
    EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  return eglChooseConfig(display, attributes, &config, 1, &count) && count > 0 ? config : nullptr;
}

EGLContext CreateContext(
  EGLDisplay display, EGLConfig config, const rtwEGLContext::Request& request)
{
  for (const auto& version : Versions)
  {
    if (version[0] > request.MaximumMajor ||
      (version[0] == request.MaximumMajor && version[1] > request.MaximumMinor))
    {
      continue;
    }
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0], EGL_CONTEXT_MINOR_VERSION,
      version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT)
    {
      return context;
    }
  }
  return EGL_NO_CONTEXT;
}

// The client API is a setting of the thread, which the host application may use for another.
class ScopedOpenGLAPI
{
public:
  ScopedOpenGLAPI()
    : Before(eglQueryAPI())
  {
    this->Bound = eglBindAPI(EGL_OPENGL_API);
  }
  ~ScopedOpenGLAPI() { eglBindAPI(this->Before); }
  ScopedOpenGLAPI(const ScopedOpenGLAPI&) = delete;
  void operator=(const ScopedOpenGLAPI&) = delete;
  bool IsBound() const { return this->Bound == EGL_TRUE; }

private:
  EGLenum Before;
  EGLBoolean Bound;
};
}

int rtwEGLContext::GetNumberOfDevices()
{
  return static_cast<int>(GetDevices().size());
}

void (*rtwEGLContext::GetFunction(const char* name))()
{
  return eglGetProcAddress(name);
}

std::unique_ptr<rtwEGLContext> rtwEGLContext::Create(const Request& request, std::string& why)
{
  const std::vector<EGLDeviceEXT> devices = GetDevices();
  const int count = static_cast<int>(devices.size());
  if (request.DeviceIndex >= count)
  {
    why = "there is no EGL device " + std::to_string(request.DeviceIndex) + ", only " +
      std::to_string(count) + " of them (-1 takes the first that works)";
    return nullptr;
  }

  std::unique_ptr<rtwEGLContext> context(new rtwEGLContext);
  why = "EGL has no devices and no displays";
  for (int i = 0; i < count; ++i)
  {
    if (request.DeviceIndex >= 0 && request.DeviceIndex != i)
    {
      continue;
    }
    EGLDisplay display = GetPlatformDisplay(
      EGL_PLATFORM_DEVICE_EXT, "EGL_EXT_platform_device", devices[static_cast<size_t>(i)]);
    if (context->Open(display, request, why))
    {
      context->DeviceIndex = i;
      return context;
    }
  }
  if (request.DeviceIndex < 0 &&
    (context->Open(GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                     "EGL_MESA_platform_surfaceless", EGL_DEFAULT_DISPLAY),
       request, why) ||
      context->Open(eglGetDisplay(EGL_DEFAULT_DISPLAY), request, why)))
  {
    return context;
  }
  return nullptr;
}

bool rtwEGLContext::Open(void* display, const Request& request, std::string& why)
{
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
  {
    return false;
  }
  const ScopedOpenGLAPI api;
  if (!api.IsBound())
  {
    why = "the EGL driver has no desktop OpenGL";
    return false;
  }
  // VTK >= 9.3 asks for the bits of the default framebuffer, hence a tiny pbuffer. Where the driver
  // has none, a context with no surface at all does.
  EGLConfig config = ChooseConfig(display, EGL_PBUFFER_BIT);
  const bool pbuffer = config != nullptr;
  if (!pbuffer)
  {
    config = ChooseConfig(display, EGL_DONT_CARE);
    if (!config || !HasExtension(display, "EGL_KHR_surfaceless_context"))
    {
      why = "the EGL driver has no configuration for off-screen OpenGL";
      return false;
    }
  }
  this->Context = CreateContext(display, config, request);
  if (this->Context == EGL_NO_CONTEXT)
  {
    why = "the EGL driver has no OpenGL 3.2 core context";
    return false;
  }
  this->Display = display;
  if (pbuffer)
  {
    const EGLint attributes[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE };
    this->Surface = eglCreatePbufferSurface(display, config, attributes);
  }
  return true;
}

rtwEGLContext::~rtwEGLContext()
{
  if (!this->Context)
  {
    return;
  }
  if (this->IsCurrent())
  {
    this->ReleaseCurrent();
  }
  this->GiveBack();
  if (this->Surface)
  {
    eglDestroySurface(this->Display, this->Surface);
  }
  eglDestroyContext(this->Display, this->Context);
  // No eglTerminate: a display is one for the whole process and does not count its users, so that
  // would take the contexts of other windows, and of the host application, with it.
}

rtwEGLContext::Status rtwEGLContext::MakeCurrent()
{
  if (this->IsCurrent())
  {
    return Status::Current;
  }
  EGLBoolean made = eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context);
  EGLint error = made ? EGL_SUCCESS : eglGetError();
  if (error == EGL_BAD_ACCESS && this->Displace())
  {
    made = eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context);
    error = made ? EGL_SUCCESS : eglGetError();
    if (!made)
    {
      this->GiveBack();
    }
  }
  if (made)
  {
    return Status::Current;
  }
  // All but BAD_ACCESS say that what was there when it was made is there no more.
  return error == EGL_BAD_ACCESS ? Status::Failed : Status::Lost;
}

void rtwEGLContext::ReleaseCurrent()
{
  eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool rtwEGLContext::Displace()
{
  std::unique_ptr<rtwGLXContext> taken = rtwGLXContext::Take();
  if (!taken)
  {
    return false;
  }
  if (this->Displaced)
  {
    this->Displaced->Forget(); // GLX has had the place again meanwhile
  }
  this->Displaced = std::move(taken);
  return true;
}

void rtwEGLContext::GiveBack()
{
  if (this->Displaced)
  {
    this->ReleaseCurrent();
    this->Displaced.reset();
  }
}

bool rtwEGLContext::IsCurrent() const
{
  const ScopedOpenGLAPI api; // what is current is asked of the bound API
  return eglGetCurrentContext() == this->Context;
}

#else // no EGL on this platform

int rtwEGLContext::GetNumberOfDevices()
{
  return 0;
}

void (*rtwEGLContext::GetFunction(const char*))()
{
  return nullptr;
}

std::unique_ptr<rtwEGLContext> rtwEGLContext::Create(const Request&, std::string& why)
{
  why = "this build of vtkRTWShadows has no EGL";
  return nullptr;
}

bool rtwEGLContext::Open(void*, const Request&, std::string&)
{
  return false;
}

rtwEGLContext::~rtwEGLContext() = default;

rtwEGLContext::Status rtwEGLContext::MakeCurrent()
{
  return Status::Failed;
}

void rtwEGLContext::ReleaseCurrent() {}

void rtwEGLContext::GiveBack() {}

bool rtwEGLContext::IsCurrent() const
{
  return false;
}

#endif
