// SPDX-License-Identifier: BSD-3-Clause
// Other code may end EGL's display, and all contexts with it: VTK >= 9.4 does so when it looks for
// a window that works. vtkRTWEGLRenderWindow goes on with a new one.
#include "rtwTest.h"

#include "vtkRTWEGLRenderWindow.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#if RTW_HAVE_EGL
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#endif

int TestEGLRenderWindowLost(int, char*[])
{
#if RTW_HAVE_EGL
  vtkNew<vtkRTWEGLRenderWindow> window;
  vtkNew<vtkRTWEGLRenderWindow> other;
  for (vtkRTWEGLRenderWindow* one : { window.Get(), other.Get() })
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1.0, 0.5, 0.0);
    one->AddRenderer(renderer);
    one->SetSize(40, 30);
    one->Render();
  }
  other->ReleaseCurrent();
  eglTerminate(window->GetGenericDisplayId());
  {
    rtwMessageCatcher messages(window);
    vtkNew<vtkUnsignedCharArray> pixels;
    RTW_CHECK_EQUAL(window->GetPixelData(0, 0, 39, 29, 0, pixels, 0), VTK_ERROR);
    RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 2); // it is lost, so there is no picture
    RTW_CHECK(!window->HasContext());
    window->Render();
    RTW_CHECK_PIXEL(rtwGrab(window), 20, 15, 255, 128, 0);
    RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 2);
  }
  window->ReleaseCurrent();
  eglTerminate(window->GetGenericDisplayId());
  {
    rtwMessageCatcher messages(window);
    window->Render(); // at once, in one
    RTW_CHECK_PIXEL(rtwGrab(window), 20, 15, 255, 128, 0);
    RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  }
  // The other window goes away with what it lost, and tells nothing.
  return rtwTestResult();
#else
  return rtwTestSkipped;
#endif
}
