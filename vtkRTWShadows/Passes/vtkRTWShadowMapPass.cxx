// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRTWShadowMapPass.h"

#include "vtkObjectFactory.h"
#include "vtkRectilinearShadowMapWarp.h"

vtkStandardNewMacro(vtkRTWShadowMapPass);

static_assert(
  int(vtkRTWShadowMapPass::SAMPLE_COUNT) == int(vtkRectilinearShadowMapWarp::SAMPLE_COUNT) &&
    int(vtkRTWShadowMapPass::HYBRID) == int(vtkRectilinearShadowMapWarp::HYBRID) &&
    int(vtkRTWShadowMapPass::SPHERE) == int(vtkRectilinearShadowMapWarp::SPHERE),
  "the enumerations end alike");

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

void vtkRTWShadowMapPass::SetTemporalBlending(double share)
{
  this->Rectilinear->SetTemporalBlending(share);
}

double vtkRTWShadowMapPass::GetTemporalBlending()
{
  return this->Rectilinear->GetTemporalBlending();
}

void vtkRTWShadowMapPass::SetSnapping(bool snap)
{
  this->Rectilinear->SetSnapping(snap);
}

bool vtkRTWShadowMapPass::GetSnapping()
{
  return this->Rectilinear->GetSnapping();
}

void vtkRTWShadowMapPass::SetCullEmptyCells(bool cull)
{
  this->Rectilinear->SetCullEmptyCells(cull);
}

bool vtkRTWShadowMapPass::GetCullEmptyCells()
{
  return this->Rectilinear->GetCullEmptyCells();
}

void vtkRTWShadowMapPass::SetAnalysis(int analysis)
{
  this->Rectilinear->SetAnalysis(analysis);
}

int vtkRTWShadowMapPass::GetAnalysis()
{
  return this->Rectilinear->GetAnalysis();
}

void vtkRTWShadowMapPass::SetLightImageResolution(int texels)
{
  this->Rectilinear->SetLightImageResolution(texels);
}

int vtkRTWShadowMapPass::GetLightImageResolution()
{
  return this->Rectilinear->GetLightImageResolution();
}

void vtkRTWShadowMapPass::SetEdgeThreshold(double share)
{
  this->Rectilinear->SetEdgeThreshold(share);
}

double vtkRTWShadowMapPass::GetEdgeThreshold()
{
  return this->Rectilinear->GetEdgeThreshold();
}

void vtkRTWShadowMapPass::SetSurfaceNormalBonus(double bonus)
{
  this->Rectilinear->SetSurfaceNormalBonus(bonus);
}

double vtkRTWShadowMapPass::GetSurfaceNormalBonus()
{
  return this->Rectilinear->GetSurfaceNormalBonus();
}

void vtkRTWShadowMapPass::SetInterest(int interest)
{
  this->Rectilinear->SetInterest(interest);
}

int vtkRTWShadowMapPass::GetInterest()
{
  return this->Rectilinear->GetInterest();
}

void vtkRTWShadowMapPass::SetInterestRadius(double radius)
{
  this->Rectilinear->SetInterestRadius(radius);
}

double vtkRTWShadowMapPass::GetInterestRadius()
{
  return this->Rectilinear->GetInterestRadius();
}

void vtkRTWShadowMapPass::SetInterestViewRadius(double share)
{
  this->Rectilinear->SetInterestViewRadius(share);
}

double vtkRTWShadowMapPass::GetInterestViewRadius()
{
  return this->Rectilinear->GetInterestViewRadius();
}

void vtkRTWShadowMapPass::SetInterestBonus(double bonus)
{
  this->Rectilinear->SetInterestBonus(bonus);
}

double vtkRTWShadowMapPass::GetInterestBonus()
{
  return this->Rectilinear->GetInterestBonus();
}

void vtkRTWShadowMapPass::SetInterestCentre(double x, double y, double z)
{
  this->Rectilinear->SetInterestCentre(x, y, z);
}

void vtkRTWShadowMapPass::SetInterestCentre(const double centre[3])
{
  this->Rectilinear->SetInterestCentre(centre);
}

double* vtkRTWShadowMapPass::GetInterestCentre()
{
  return this->Rectilinear->GetInterestCentre();
}

void vtkRTWShadowMapPass::SetUserFunction(const char* glsl)
{
  this->Rectilinear->SetUserFunction(glsl);
}

const char* vtkRTWShadowMapPass::GetUserFunction()
{
  return this->Rectilinear->GetUserFunction();
}

void vtkRTWShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RectilinearWarp: " << this->Rectilinear.Get() << "\n";
}
