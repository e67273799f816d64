// SPDX-License-Identifier: BSD-3-Clause
// On a machine with no EGL driver, vtkRTWEGLRenderWindow says once what to do, and does no harm.
#include "rtwTest.h"

#include "vtkRTWEGLRenderWindow.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

int TestEGLRenderWindowWithoutDriver(int, char*[])
{
  vtkNew<vtkRTWEGLRenderWindow> window;
  if (window->SupportsOpenGL())
  {
    return rtwTestSkipped; // this loader does not heed the variables that hide the drivers
  }
  RTW_CHECK_EQUAL(window->GetNumberOfDevices(), 0);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->SetSize(40, 30);

  rtwMessageCatcher messages(window);
  window->Render();
  window->Render();
  window->Start();
  window->End();
  window->MakeCurrent();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 1);
  RTW_CHECK(messages.GetText().find("libgl1-mesa-dri") != std::string::npos);
  RTW_CHECK(!window->HasContext());
  RTW_CHECK(!window->IsCurrent());
  RTW_CHECK(!window->IsDirect());
  RTW_CHECK_EQUAL(window->GetOpenGLMajorVersion(), 0);

  vtkNew<vtkUnsignedCharArray> pixels;
  RTW_CHECK_EQUAL(window->GetPixelData(0, 0, 39, 29, 0, pixels, 0), VTK_ERROR);
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->Update();
  window->Finalize();
  return rtwTestResult();
}
