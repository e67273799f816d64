// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthSplitShadowMapPartition.h"

#include "Partition/rtwDepthSplitStage.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkDepthSplitShadowMapPartition);

vtkDepthSplitShadowMapPartition::vtkDepthSplitShadowMapPartition() = default;
vtkDepthSplitShadowMapPartition::~vtkDepthSplitShadowMapPartition() = default;

void vtkDepthSplitShadowMapPartition::SetSplitScheme(int scheme)
{
  if (scheme < UNIFORM || scheme > SAMPLE_DISTRIBUTION)
  {
    vtkErrorMacro("SetSplitScheme(" << scheme
                                    << "): expected UNIFORM (0), LOGARITHMIC (1), PRACTICAL (2) or "
                                       "SAMPLE_DISTRIBUTION (3); keeping "
                                    << this->SplitScheme);
    return;
  }
  if (this->SplitScheme != scheme)
  {
    this->SplitScheme = scheme;
    this->Modified();
  }
}

void vtkDepthSplitShadowMapPartition::SetShare(double& member, double share, const char* property)
{
  if (!std::isfinite(share))
  {
    vtkErrorMacro(
      "Set" << property << "(" << share << "): expected a number from 0 to 1; keeping " << member);
    return;
  }
  share = std::clamp(share, 0.0, 1.0);
  if (member != share)
  {
    member = share;
    this->Modified();
  }
}

void vtkDepthSplitShadowMapPartition::SetLambda(double lambda)
{
  this->SetShare(this->Lambda, lambda, "Lambda");
}

void vtkDepthSplitShadowMapPartition::SetBlendWidth(double share)
{
  this->SetShare(this->BlendWidth, share, "BlendWidth");
}

std::unique_ptr<rtw::PartitionStage> vtkDepthSplitShadowMapPartition::MakeStage()
{
  return std::make_unique<rtw::DepthSplitStage>([this] {
    rtw::DepthSplitSettings settings;
    settings.Layers = this->NumberOfLayers;
    settings.BySamples = this->SplitScheme == SAMPLE_DISTRIBUTION;
    settings.Lambda =
      this->SplitScheme == PRACTICAL ? this->Lambda : double(this->SplitScheme != UNIFORM);
    settings.Steady = this->Stable;
    settings.Faces = this->SplitFaces;
    settings.Blend = this->BlendWidth;
    return settings;
  });
}

void vtkDepthSplitShadowMapPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitScheme: " << this->SplitScheme << "\n";
  os << indent << "Lambda: " << this->Lambda << "\n";
  os << indent << "BlendWidth: " << this->BlendWidth << "\n";
  os << indent << "SplitFaces: " << this->SplitFaces << "\n";
  os << indent << "Stable: " << this->Stable << "\n";
}
