// SPDX-License-Identifier: BSD-3-Clause
#include "rtwGLXContext.h"

#if RTW_HAVE_EGL && !defined(_WIN32)

#include <dlfcn.h>

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
    Find(this->GetCurrentDisplay, "glXGetCurrentDisplay");
    Find(this->GetCurrentDrawable, "glXGetCurrentDrawable");
    Find(this->GetCurrentContext, "glXGetCurrentContext");
    Find(this->MakeCurrent, "glXMakeCurrent");
  }
  bool AreThere() const
  {
    return this->GetCurrentDisplay && this->GetCurrentDrawable && this->GetCurrentContext &&
      this->MakeCurrent;
  }

private:
  template <typename Function>
  static void Find(Function& function, const char* name)
  {
    function = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
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
