// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRTWShadowMapPass.h"

#include "vtkObjectFactory.h"
#include "vtkRectilinearShadowMapWarp.h"

vtkStandardNewMacro(vtkRTWShadowMapPass);

vtkRTWShadowMapPass::vtkRTWShadowMapPass()
{
  this->SetWarp(this->Rectilinear);
}

vtkRTWShadowMapPass::~vtkRTWShadowMapPass() = default;

vtkRectilinearShadowMapWarp* vtkRTWShadowMapPass::GetRectilinearWarp()
{
  return this->Rectilinear;
}

void vtkRTWShadowMapPass::SetImportance(int functions)
{
  this->Rectilinear->SetImportance(functions);
}

int vtkRTWShadowMapPass::GetImportance()
{
  return this->Rectilinear->GetImportance();
}

void vtkRTWShadowMapPass::SetImportanceResolution(int cells)
{
  this->Rectilinear->SetImportanceResolution(cells);
}

int vtkRTWShadowMapPass::GetImportanceResolution()
{
  return this->Rectilinear->GetImportanceResolution();
}

void vtkRTWShadowMapPass::SetBlurSigma(double cells)
{
  this->Rectilinear->SetBlurSigma(cells);
}

double vtkRTWShadowMapPass::GetBlurSigma()
{
  return this->Rectilinear->GetBlurSigma();
}

void vtkRTWShadowMapPass::SetImportanceFloor(double share)
{
  this->Rectilinear->SetImportanceFloor(share);
}

double vtkRTWShadowMapPass::GetImportanceFloor()
{
  return this->Rectilinear->GetImportanceFloor();
}

void vtkRTWShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RectilinearWarp: " << this->Rectilinear.Get() << "\n";
}
