// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPerspectiveShadowMapPass.h"

#include "vtkObjectFactory.h"
#include "vtkPerspectiveShadowMapWarp.h"

vtkStandardNewMacro(vtkPerspectiveShadowMapPass);

static_assert(int(vtkPerspectiveShadowMapPass::BY_NEAR_DISTANCE) ==
      int(vtkPerspectiveShadowMapWarp::BY_NEAR_DISTANCE) &&
    int(vtkPerspectiveShadowMapPass::SPLIT_BY_RATIO) ==
      int(vtkPerspectiveShadowMapWarp::SPLIT_BY_RATIO),
  "the enumerations end alike");

vtkPerspectiveShadowMapPass::vtkPerspectiveShadowMapPass()
{
  this->SetWarp(this->Perspective);
}

vtkPerspectiveShadowMapPass::~vtkPerspectiveShadowMapPass() = default;

vtkPerspectiveShadowMapWarp* vtkPerspectiveShadowMapPass::GetPerspectiveWarp()
{
  return this->Perspective;
}

void vtkPerspectiveShadowMapPass::SetParameterization(int parameterization)
{
  this->Perspective->SetParameterization(parameterization);
}

int vtkPerspectiveShadowMapPass::GetParameterization()
{
  return this->Perspective->GetParameterization();
}

void vtkPerspectiveShadowMapPass::SetEta(double eta)
{
  this->Perspective->SetEta(eta);
}

double vtkPerspectiveShadowMapPass::GetEta()
{
  return this->Perspective->GetEta();
}

void vtkPerspectiveShadowMapPass::SetNearDistance(double distance)
{
  this->Perspective->SetNearDistance(distance);
}

double vtkPerspectiveShadowMapPass::GetNearDistance()
{
  return this->Perspective->GetNearDistance();
}

void vtkPerspectiveShadowMapPass::SetFocusPoint(double share)
{
  this->Perspective->SetFocusPoint(share);
}

double vtkPerspectiveShadowMapPass::GetFocusPoint()
{
  return this->Perspective->GetFocusPoint();
}

void vtkPerspectiveShadowMapPass::SetResolutionSplit(int split)
{
  this->Perspective->SetResolutionSplit(split);
}

int vtkPerspectiveShadowMapPass::GetResolutionSplit()
{
  return this->Perspective->GetResolutionSplit();
}

void vtkPerspectiveShadowMapPass::SetResolutionRatio(double ratio)
{
  this->Perspective->SetResolutionRatio(ratio);
}

double vtkPerspectiveShadowMapPass::GetResolutionRatio()
{
  return this->Perspective->GetResolutionRatio();
}

void vtkPerspectiveShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PerspectiveWarp: " << this->Perspective.Get() << "\n";
}
