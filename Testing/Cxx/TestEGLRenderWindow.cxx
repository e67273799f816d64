// SPDX-License-Identifier: BSD-3-Clause
// vtkRTWEGLRenderWindow draws, resizes, comes back after Finalize(), lives beside others, and bears
// with nonsense.
#include "rtwTest.h"

#include "vtkRTWEGLRenderWindow.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <thread>

namespace
{
// A flat-coloured sphere that fills the middle half of the height, before a flat background.
void AddSphere(vtkRenderer* renderer, double r, double g, double b)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  renderer->SetBackground(0.2, 0.4, 0.6);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.0);
  camera->SetPosition(0, 0, 10);
  camera->SetFocalPoint(0, 0, 0);
  renderer->ResetCameraClippingRange();
}

void CheckPicture(vtkRenderWindow* window, int width, int height, int r, int g, int b)
{
  const auto image = rtwGrab(window);
  RTW_CHECK_EQUAL(image->GetDimensions()[0], width);
  RTW_CHECK_EQUAL(image->GetDimensions()[1], height);
  RTW_CHECK_PIXEL(image, width / 2, height / 2, r, g, b);
  RTW_CHECK_PIXEL(image, width / 2, height * 2 / 3, r, g, b);
  RTW_CHECK_PIXEL(image, 1, 1, 51, 102, 153);
  RTW_CHECK_PIXEL(image, width - 2, height - 2, 51, 102, 153);
}

void TestLife()
{
  vtkNew<vtkRTWEGLRenderWindow> window;
  RTW_CHECK(!window->HasContext());
  RTW_CHECK_EQUAL(window->GetCurrentDeviceIndex(), -1);
  vtkNew<vtkRenderer> renderer;
  AddSphere(renderer, 1.0, 0.5, 0.0);
  window->AddRenderer(renderer);
  window->SetSize(120, 80);
  window->Render();
  RTW_CHECK(window->HasContext());
  RTW_CHECK(window->IsDirect());
  RTW_CHECK(window->SupportsOpenGL());
  CheckPicture(window, 120, 80, 255, 128, 0);

  window->SetSize(200, 260);
  window->Render();
  CheckPicture(window, 200, 260, 255, 128, 0);

  for (int i = 0; i < 3; ++i)
  {
    window->Finalize();
    RTW_CHECK(!window->HasContext());
    RTW_CHECK(!window->IsCurrent());
    window->Finalize(); // once more does no harm
    window->SetSize(90 + i, 70);
    window->Render();
    CheckPicture(window, 90 + i, 70, 255, 128, 0);
  }

  std::ostringstream text;
  window->Print(text);
  RTW_CHECK(text.str().find("HasContext: yes") != std::string::npos);
  const std::string capabilities = window->ReportCapabilities();
  RTW_CHECK(capabilities.find("OpenGL version string") != std::string::npos);
}

void TestSamplesAndDepth()
{
  for (const int samples : { 0, 4 })
  {
    vtkNew<vtkRTWEGLRenderWindow> window;
    window->SetMultiSamples(samples);
    window->SetSize(101, 77);
    vtkNew<vtkRenderer> renderer;
    AddSphere(renderer, 1.0, 1.0, 1.0);
    window->AddRenderer(renderer);
    window->Render();
    CheckPicture(window, 101, 77, 255, 255, 255);
    const auto image = rtwGrab(window);
    int between = 0;
    for (int x = 0; x < 101; ++x)
    {
      for (int y = 0; y < 77; ++y)
      {
        const int red = rtwPixel(image, x, y)[0];
        between += red > 60 && red < 245;
      }
    }
    RTW_CHECK_EQUAL(between > 20, samples > 0); // only multisampling has in-between colours

    float depth[2] = { -1.0f, -1.0f };
    RTW_CHECK_EQUAL(window->GetZbufferData(50, 38, 50, 38, depth), VTK_OK);
    RTW_CHECK_EQUAL(window->GetZbufferData(1, 1, 1, 1, depth + 1), VTK_OK);
    RTW_CHECK(depth[0] < 0.9f);
    RTW_CHECK_NEAR(depth[1], 1.0, 1e-6);
  }
}

void TestSeveral()
{
  vtkNew<vtkRTWEGLRenderWindow> red;
  vtkNew<vtkRenderer> redRenderer;
  AddSphere(redRenderer, 1.0, 0.0, 0.0);
  red->AddRenderer(redRenderer);
  red->SetSize(60, 60);
  {
    vtkNew<vtkRTWEGLRenderWindow> green;
    vtkNew<vtkRenderer> greenRenderer;
    AddSphere(greenRenderer, 0.0, 1.0, 0.0);
    green->AddRenderer(greenRenderer);
    green->SetSize(50, 70);
    for (int i = 0; i < 2; ++i)
    {
      red->Render();
      green->Render();
      RTW_CHECK(green->IsCurrent());
      RTW_CHECK(!red->IsCurrent());
      CheckPicture(red, 60, 60, 255, 0, 0);
      CheckPicture(green, 50, 70, 0, 255, 0);
    }
    red->Render();
  }
  red->Render();
  CheckPicture(red, 60, 60, 255, 0, 0);

  // One renderer moves from a window to another, whose context knows none of its resources.
  vtkNew<vtkRTWEGLRenderWindow> other;
  other->SetSize(64, 48);
  red->RemoveRenderer(redRenderer);
  other->AddRenderer(redRenderer);
  other->Render();
  CheckPicture(other, 64, 48, 255, 0, 0);
}

void TestThreads()
{
  vtkNew<vtkRTWEGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  AddSphere(renderer, 1.0, 0.5, 0.0);
  window->AddRenderer(renderer);
  window->SetSize(40, 30);
  window->Render();
  rtwMessageCatcher messages(window);
  std::thread([&] { window->Render(); }).join();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 1); // this thread has it
  RTW_CHECK(messages.GetText().find("ReleaseCurrent") != std::string::npos);
  window->ReleaseCurrent();
  RTW_CHECK(!window->IsCurrent());
  window->ReleaseCurrent();
  std::thread([&] {
    window->Render();
    CheckPicture(window, 40, 30, 255, 128, 0);
    window->ReleaseCurrent();
  }).join();
  CheckPicture(window, 40, 30, 255, 128, 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 1);
}

void TestNonsense()
{
  { // never rendered
    vtkNew<vtkRTWEGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    window->AddRenderer(renderer);
    window->Finalize();
    rtwMessageCatcher messages(window);
    float depth = 0.0f;
    RTW_CHECK_EQUAL(window->GetZbufferData(0, 0, 0, 0, &depth), VTK_ERROR);
    RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
    RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  }
  { // no size, and no renderer
    vtkNew<vtkRTWEGLRenderWindow> window;
    window->SetSize(0, 0);
    window->Render();
    vtkNew<vtkRenderer> renderer;
    AddSphere(renderer, 1.0, 0.5, 0.0);
    window->AddRenderer(renderer);
    window->SetSize(0, 40);
    window->Render();
    CheckPicture(window, 300, 40, 255, 128, 0);
    window->SetSize(0, 0);
    window->Render();
    CheckPicture(window, 300, 300, 255, 128, 0);
    window->SetSize(1, 1);
    window->Render();
  }
  { // no such device
    vtkNew<vtkRTWEGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    AddSphere(renderer, 1.0, 0.5, 0.0);
    window->AddRenderer(renderer);
    window->SetSize(40, 30);
    window->SetDeviceIndex(1000);
    {
      rtwMessageCatcher messages(window);
      RTW_CHECK(!window->SupportsOpenGL()); // a question is not an error
      RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
      window->Render();
      window->Render();
      RTW_CHECK_EQUAL(window->GetOpenGLMajorVersion(), 0);
      RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 1);
      RTW_CHECK(messages.GetText().find("device 1000") != std::string::npos);
      RTW_CHECK(std::strstr(window->ReportCapabilities(), "device 1000") != nullptr);
    }
    window->SetDeviceIndex(-7);
    RTW_CHECK_EQUAL(window->GetDeviceIndex(), -1);
    window->Render(); // and now it works
    CheckPicture(window, 40, 30, 255, 128, 0);
  }
}

void TestDevices()
{
  vtkNew<vtkRTWEGLRenderWindow> any;
  for (int i = 0; i < any->GetNumberOfDevices(); ++i)
  {
    vtkNew<vtkRTWEGLRenderWindow> window;
    window->SetDeviceIndex(i);
    // A device that this user may not open is no fault of the window's.
    if (window->SupportsOpenGL())
    {
      RTW_CHECK_EQUAL(window->GetCurrentDeviceIndex(), i);
      vtkNew<vtkRenderer> renderer;
      AddSphere(renderer, 0.0, 0.0, 1.0);
      window->AddRenderer(renderer);
      window->SetSize(40, 30);
      window->Render();
      CheckPicture(window, 40, 30, 0, 0, 255);
    }
  }
}

void TestDefault()
{
  vtkRTWEGLRenderWindow::UninstallAsDefault();
  RTW_CHECK(vtkRTWEGLRenderWindow::InstallAsDefault(false));
  RTW_CHECK(vtkRTWEGLRenderWindow::InstallAsDefault(true));
  vtkNew<vtkRenderWindow> window;
  RTW_CHECK_EQUAL(std::string(window->GetClassName()), "vtkRTWEGLRenderWindow");
  vtkNew<vtkRenderer> renderer;
  AddSphere(renderer, 1.0, 0.5, 0.0);
  window->AddRenderer(renderer);
  window->SetSize(40, 30);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Initialize();
  interactor->Start(); // returns at once
  window->Render();
  CheckPicture(window, 40, 30, 255, 128, 0);

  vtkRTWEGLRenderWindow::UninstallAsDefault();
  vtkRTWEGLRenderWindow::UninstallAsDefault();
  vtkNew<vtkRenderWindow> native;
  RTW_CHECK(std::string(native->GetClassName()) != "vtkRTWEGLRenderWindow");

#ifndef _WIN32
  setenv("DISPLAY", ":1", 1);
  RTW_CHECK(!vtkRTWEGLRenderWindow::InstallAsDefault());
  RTW_CHECK(vtkRTWEGLRenderWindow::InstallAsDefault(false));
  vtkRTWEGLRenderWindow::UninstallAsDefault();
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  RTW_CHECK(vtkRTWEGLRenderWindow::InstallAsDefault());
#endif
}
}

int TestEGLRenderWindow(int, char*[])
{
  TestLife();
  TestSamplesAndDepth();
  TestSeveral();
  TestThreads();
  TestNonsense();
  TestDevices();
  TestDefault();
  return rtwTestResult();
}
