// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNonOrthogonalShadowMapWarp.h"

#include "Warp/NonOrthogonal/rtwNonOrthogonalWarpStage.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkNonOrthogonalShadowMapWarp);

vtkNonOrthogonalShadowMapWarp::vtkNonOrthogonalShadowMapWarp() = default;
vtkNonOrthogonalShadowMapWarp::~vtkNonOrthogonalShadowMapWarp() = default;

void vtkNonOrthogonalShadowMapWarp::SetWeights(int weights)
{
  if (weights != COUNT && weights != SQRT_DEMAND)
  {
    vtkErrorMacro("SetWeights(" << weights << "): expected COUNT (0) or SQRT_DEMAND (1); keeping "
                                << this->Weights);
    return;
  }
  if (this->Weights != weights)
  {
    this->Weights = weights;
    this->Modified();
  }
}

void vtkNonOrthogonalShadowMapWarp::SetSmoothing(double share)
{
  if (!std::isfinite(share))
  {
    vtkErrorMacro(
      "SetSmoothing(" << share << "): expected a number from 0 to 1; keeping " << this->Smoothing);
    return;
  }
  share = std::clamp(share, 0.0, 1.0);
  if (this->Smoothing != share)
  {
    this->Smoothing = share;
    this->Modified();
  }
}

std::unique_ptr<rtw::WarpStage> vtkNonOrthogonalShadowMapWarp::MakeStage()
{
  return std::make_unique<rtw::NonOrthogonalWarpStage>([this] {
    rtw::NonOrthogonalSettings settings;
    settings.Demand = this->Weights == SQRT_DEMAND;
    settings.Cells = this->ImportanceResolution;
    settings.Automatic = this->AutomaticSmoothing;
    settings.Smoothing = this->Smoothing;
    return settings;
  });
}

void vtkNonOrthogonalShadowMapWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "ImportanceResolution: " << this->ImportanceResolution << "\n";
  os << indent << "AutomaticSmoothing: " << this->AutomaticSmoothing << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
}
