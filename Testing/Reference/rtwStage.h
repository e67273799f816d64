// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the reference look at.
#ifndef rtwStage_h
#define rtwStage_h

#include "rtwCompare.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

template <class Source>
vtkSmartPointer<vtkActor> MakeActor(Source source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

// A ground under a light from above, and a camera that looks down at it from aside.
class Stage
{
public:
  Stage()
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-10, 0, 10);
    plane->SetPoint1(10, 0, 10);
    plane->SetPoint2(-10, 0, -10);
    this->Ground = MakeActor(plane.Get());
    this->Renderer->AddActor(this->Ground);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 8, 9);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 50);
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPosition(1, 3, 1);
    this->Light->SetFocalPoint(0, 0, 0);
  }

  rtw::Truth Trace(const rtw::ReferenceOptions& options = {}) const
  {
    return rtw::ShadowReference(this->Renderer, options).Trace(this->Light, 120, 90);
  }

  size_t Shadowed(const rtw::ReferenceOptions& options = {}) const
  {
    const rtw::Truth truth = this->Trace(options);
    return rtw::Compare(truth.Mask, truth).Shadowed;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkSmartPointer<vtkActor> Ground;
};

// A ball in the air over it.
inline vtkSmartPointer<vtkActor> MakeBall(double x)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, 1.5, 0);
  sphere->SetRadius(0.8);
  return MakeActor(sphere.Get());
}

inline size_t Differences(const rtw::Truth& a, const rtw::Truth& b)
{
  size_t differences = 0;
  for (size_t i = 0; i < a.Mask.size(); ++i)
  {
    differences += a.Mask[i] != b.Mask[i];
  }
  return differences;
}

#endif
