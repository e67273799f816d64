// SPDX-License-Identifier: BSD-3-Clause
// A vtkRTWEGLRenderWindow beside VTK's own window, by GLX, in one thread, which has room for one
// current context only. Needs a display.
#include "rtwTest.h"

#include "vtkRTWEGLRenderWindow.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

namespace
{
void SetUp(vtkRenderWindow* window, double red)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(red, 0.4, 0.2);
  window->AddRenderer(renderer);
  window->SetSize(120, 80);
}

void Draw(vtkRenderWindow* window, int red)
{
  window->Render();
  RTW_CHECK_PIXEL(rtwGrab(window), 60, 40, red, 102, 51);
}
}

int TestEGLRenderWindowBesideX(int, char*[])
{
  vtkRTWEGLRenderWindow::UninstallAsDefault();
  vtkNew<vtkRenderWindow> native;
  if (!native->IsA("vtkXOpenGLRenderWindow"))
  {
    return rtwTestSkipped;
  }
  vtkNew<vtkRTWEGLRenderWindow> headless;
  SetUp(native, 1.0);
  SetUp(headless, 0.0);

  headless->Render(); // first, so it has to let go by hand
  RTW_CHECK(headless->IsCurrent());
  headless->ReleaseCurrent();

  for (int i = 0; i < 3; ++i)
  {
    Draw(native, 255);
    RTW_CHECK(native->IsCurrent());
    Draw(headless, 0);
    RTW_CHECK(native->IsCurrent()); // as before
  }
  {
    vtkNew<vtkRTWEGLRenderWindow> another;
    SetUp(another, 0.6);
    Draw(another, 153);
    Draw(headless, 0);
    Draw(another, 153);
    Draw(native, 255);
  }
  RTW_CHECK(native->IsCurrent());
  headless->Finalize();
  RTW_CHECK(native->IsCurrent());
  Draw(native, 255);
  Draw(headless, 0);
  Draw(native, 255);
  return rtwTestResult();
}
