// SPDX-License-Identifier: BSD-3-Clause
#include "rtwDeepStage.h"

#include "vtkCamera.h"
#include "vtkPlaneSource.h"

#include <iostream>

rtwDeepStage::rtwDeepStage(rtwTechnique technique, int floorCells, bool roof)
  : rtwShadowStage(technique)
{
  constexpr double side = 300;
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-side / 2, 0, side / 2);
  floor->SetPoint1(side / 2, 0, side / 2);
  floor->SetPoint2(-side / 2, 0, -side / 2);
  floor->SetResolution(floorCells, floorCells);
  this->Add(floor);
  for (int i = 0; i < 12; ++i)
  {
    this->AddBox(4.0 * (i % 3) - 5.0, 1.0, 2.0 - 9.0 * i, 2.0);
  }
  if (roof)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(4, 3, -80);
    plane->SetPoint1(30, 3, -80);
    plane->SetPoint2(4, 3, 0);
    this->Add(plane);
  }
  this->Sun = this->AddSun(3, 4, 2);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0, 2.2, 12);
  camera->SetFocalPoint(0, 1.5, 0);
  this->Renderer->ResetCameraClippingRange();
  this->Pass->SetResolution(512);
  this->Truth = this->Trace(this->Sun);
}

rtw::ShadowErrors rtwDeepStage::Compare(const char* name)
{
  this->Render();
  const rtw::ShadowErrors errors = rtw::Compare(this->GetMask(0), this->Truth);
  std::cout << name << ": " << errors.Percent(errors.Wrong()) << " % wrong, "
            << errors.Percent(errors.FarFromEdge) << " % far from edges" << std::endl;
  return errors;
}
