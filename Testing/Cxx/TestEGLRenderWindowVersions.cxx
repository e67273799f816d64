// SPDX-License-Identifier: BSD-3-Clause
// vtkRTWEGLRenderWindow takes what OpenGL the driver has and says which: run with several values of
// MESA_GL_VERSION_OVERRIDE, by which Mesa plays lesser drivers.
#include "rtwTest.h"

#include "vtkRTWEGLRenderWindow.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <cstring>

namespace
{
void CheckDraws(vtkRTWEGLRenderWindow* window)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  window->AddRenderer(renderer);
  window->SetSize(60, 40);
  window->Render();
  RTW_CHECK_PIXEL(rtwGrab(window), 30, 20, 255, 0, 0);
}

// What Mesa was told to be, as 10 major + minor; 0 if it was not, or the driver is another.
int GetPlayedVersion(vtkRTWEGLRenderWindow* window)
{
  const char* version = std::getenv("MESA_GL_VERSION_OVERRIDE");
  const bool mesa = std::strstr(window->ReportCapabilities(), "Mesa") != nullptr;
  return mesa && version && std::strlen(version) == 3 ? 10 * (version[0] - '0') + (version[2] - '0')
                                                      : 0;
}
}

int TestEGLRenderWindowVersions(int, char*[])
{
  vtkNew<vtkRTWEGLRenderWindow> window;
  RTW_CHECK_EQUAL(window->GetMaximumOpenGLMajorVersion(), 4);
  RTW_CHECK_EQUAL(window->GetMaximumOpenGLMinorVersion(), 6);
  const int version = 10 * window->GetOpenGLMajorVersion() + window->GetOpenGLMinorVersion();
  RTW_CHECK(version >= 32);
  if (const int played = GetPlayedVersion(window))
  {
    RTW_CHECK_EQUAL(version, played);
  }
  CheckDraws(window);

  // Asked for less, the driver gives that or more, but no more than it has.
  for (const int asked : { 45, 41, 33, 32 })
  {
    vtkNew<vtkRTWEGLRenderWindow> lesser;
    lesser->SetMaximumOpenGLVersion(asked / 10, asked % 10);
    RTW_CHECK_EQUAL(lesser->GetMaximumOpenGLMajorVersion(), asked / 10);
    RTW_CHECK_EQUAL(lesser->GetMaximumOpenGLMinorVersion(), asked % 10);
    CheckDraws(lesser);
    const int given = 10 * lesser->GetOpenGLMajorVersion() + lesser->GetOpenGLMinorVersion();
    RTW_CHECK(given >= 32);
    RTW_CHECK(given <= version);
  }

  // There are no such versions.
  rtwMessageCatcher messages(window);
  window->SetMaximumOpenGLVersion(4, 7);
  window->SetMaximumOpenGLVersion(3, 1);
  window->SetMaximumOpenGLVersion(3, 4);
  window->SetMaximumOpenGLVersion(4, -1);
  window->SetMaximumOpenGLVersion(5, 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 5);
  RTW_CHECK_EQUAL(window->GetMaximumOpenGLMajorVersion(), 4);
  RTW_CHECK_EQUAL(window->GetMaximumOpenGLMinorVersion(), 6);
  return rtwTestResult();
}
