// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwGLXContext.h"

#if RTW_HAVE_EGL && !defined(_WIN32)

#include <dlfcn.h>
#include <initializer_list>

namespace
{
// The types are those of GLX, with its handles as the void* and its XIDs as the long that they are.
struct Functions
{
  void* (*GetCurrentDisplay)() = nullptr;
  unsigned long (*GetCurrentDrawable)() = nullptr;
  void* (*GetCurrentContext)() = nullptr;
  int (*MakeCurrent)(void* display, unsigned long drawable, void* context) = nullptr;

  Functions()
  {
    // VTK >= 9.4 opens GLX for itself, so that it is not among the global names.
    for (const char* name : { "libGLX.so.0", "libGL.so.1" })
    {
      if (void* library = dlopen(name, RTLD_LAZY | RTLD_NOLOAD))
      {
        this->FindIn(library);
        dlclose(library); // whoever loaded it still has it
      }
    }
    this->FindIn(RTLD_DEFAULT);
  }
  bool AreThere() const
  {
    return this->GetCurrentDisplay && this->GetCurrentDrawable && this->GetCurrentContext &&
      this->MakeCurrent;
  }

private:
  void FindIn(void* library)
  {
    if (!this->AreThere())
    {
      Find(this->GetCurrentDisplay, library, "glXGetCurrentDisplay");
      Find(this->GetCurrentDrawable, library, "glXGetCurrentDrawable");
      Find(this->GetCurrentContext, library, "glXGetCurrentContext");
      Find(this->MakeCurrent, library, "glXMakeCurrent");
    }
  }
  template <typename Function>
  static void Find(Function& function, void* library, const char* name)
  {
    function = reinterpret_cast<Function>(dlsym(library, name));
  }
};
}

std::unique_ptr<rtwGLXContext> rtwGLXContext::Take()
{
  const Functions glx; // looked up each time, since a library with them may come late
  if (!glx.AreThere() || !glx.GetCurrentContext() || !glx.GetCurrentDisplay())
  {
    return nullptr;
  }
  std::unique_ptr<rtwGLXContext> taken(new rtwGLXContext);
  taken->Display = glx.GetCurrentDisplay();
  taken->Drawable = glx.GetCurrentDrawable();
  taken->Context = glx.GetCurrentContext();
  glx.MakeCurrent(taken->Display, 0, nullptr);
  return taken;
}

rtwGLXContext::~rtwGLXContext()
{
  const Functions glx;
  if (this->Context && glx.AreThere())
  {
    glx.MakeCurrent(this->Display, this->Drawable, this->Context);
  }
}

#else

std::unique_ptr<rtwGLXContext> rtwGLXContext::Take()
{
  return nullptr;
}

rtwGLXContext::~rtwGLXContext() = default;

#endif
