// SPDX-License-Identifier: BSD-3-Clause
// A ball above a floor, with shadows: the three lines of the README.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkRTWEGLRenderWindow.h>
#include <vtkRTWShadowMapPass.h>
#include <vtkShadowRenderStepsPass.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <iostream>

namespace
{
void Add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

// How many of the pixels are as dark as a shadow.
int CountDark(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 199, 149, 0, pixels, 0);
  int dark = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    dark += pixels->GetComponent(i, 0) < 40;
  }
  return dark;
}
}

int main()
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-9, -9, 0);
  floor->SetPoint1(9, -9, 0);
  floor->SetPoint2(-9, 9, 0);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0, 0, 1.5);
  vtkNew<vtkLight> light;
  light->SetPosition(3, 1, 5);
  light->SetFocalPoint(0, 0, 0);
  vtkNew<vtkRenderer> renderer;
  Add(renderer, floor);
  Add(renderer, ball);
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  renderer->SetBackground(1, 1, 1);
  renderer->GetActiveCamera()->SetPosition(0, -5, 8);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRTWEGLRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetSize(200, 150);
  const int without = CountDark(window);

  vtkNew<vtkRTWShadowMapPass> shadows;
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(shadows);
  renderer->SetPass(steps);
  const int with = CountDark(window);

  std::cout << "dark pixels without shadows: " << without << ", with: " << with << "\n";
  return window->HasContext() && with > without + 20 ? 0 : 1;
}
