// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCascadedShadowMapPass.h"

#include "vtkDepthSplitShadowMapPartition.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCascadedShadowMapPass);

static_assert(int(vtkCascadedShadowMapPass::SAMPLE_DISTRIBUTION) ==
    int(vtkDepthSplitShadowMapPartition::SAMPLE_DISTRIBUTION),
  "the enumerations end alike");

vtkCascadedShadowMapPass::vtkCascadedShadowMapPass()
{
  this->SetPartition(this->DepthSplits);
}

vtkCascadedShadowMapPass::~vtkCascadedShadowMapPass() = default;

vtkDepthSplitShadowMapPartition* vtkCascadedShadowMapPass::GetDepthSplits()
{
  return this->DepthSplits;
}

void vtkCascadedShadowMapPass::SetNumberOfLayers(int layers)
{
  this->DepthSplits->SetNumberOfLayers(layers);
}

int vtkCascadedShadowMapPass::GetNumberOfLayers()
{
  return this->DepthSplits->GetNumberOfLayers();
}

void vtkCascadedShadowMapPass::SetSplitScheme(int scheme)
{
  this->DepthSplits->SetSplitScheme(scheme);
}

int vtkCascadedShadowMapPass::GetSplitScheme()
{
  return this->DepthSplits->GetSplitScheme();
}

void vtkCascadedShadowMapPass::SetLambda(double lambda)
{
  this->DepthSplits->SetLambda(lambda);
}

double vtkCascadedShadowMapPass::GetLambda()
{
  return this->DepthSplits->GetLambda();
}

void vtkCascadedShadowMapPass::SetBlendWidth(double share)
{
  this->DepthSplits->SetBlendWidth(share);
}

double vtkCascadedShadowMapPass::GetBlendWidth()
{
  return this->DepthSplits->GetBlendWidth();
}

void vtkCascadedShadowMapPass::SetStable(bool stable)
{
  this->DepthSplits->SetStable(stable);
}

bool vtkCascadedShadowMapPass::GetStable()
{
  return this->DepthSplits->GetStable();
}

void vtkCascadedShadowMapPass::SetSplitFaces(bool split)
{
  this->DepthSplits->SetSplitFaces(split);
}

bool vtkCascadedShadowMapPass::GetSplitFaces()
{
  return this->DepthSplits->GetSplitFaces();
}

void vtkCascadedShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DepthSplits: " << this->DepthSplits.Get() << "\n";
}
