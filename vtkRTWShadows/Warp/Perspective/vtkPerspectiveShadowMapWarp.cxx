// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPerspectiveShadowMapWarp.h"

#include "Warp/Perspective/rtwPerspectiveWarpStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPerspectiveShadowMapWarp);

vtkPerspectiveShadowMapWarp::vtkPerspectiveShadowMapWarp() = default;
vtkPerspectiveShadowMapWarp::~vtkPerspectiveShadowMapWarp() = default;

void vtkPerspectiveShadowMapWarp::SetParameterization(int parameterization)
{
  if (parameterization < PSM || parameterization > BY_NEAR_DISTANCE)
  {
    vtkErrorMacro("SetParameterization(" << parameterization
                                         << "): expected PSM (0), LISPSM (1), TSM (2), UNWARPED "
                                            "(3), BY_ETA (4) or BY_NEAR_DISTANCE (5); keeping "
                                         << this->Parameterization);
    return;
  }
  if (this->Parameterization != parameterization)
  {
    this->Parameterization = parameterization;
    this->Modified();
  }
}

void vtkPerspectiveShadowMapWarp::SetEta(double eta)
{
  if (!(eta >= -1 && eta <= 1))
  {
    vtkErrorMacro("SetEta(" << eta << "): expected a number from -1, no warp, to 1, PSM; keeping "
                            << this->Eta);
    return;
  }
  if (this->Eta != eta)
  {
    this->Eta = eta;
    this->Modified();
  }
  this->SetParameterization(BY_ETA);
}

void vtkPerspectiveShadowMapWarp::SetNearDistance(double distance)
{
  if (!(distance > 0))
  {
    vtkErrorMacro("SetNearDistance("
      << distance << "): expected a length above 0 in world units; keeping " << this->NearDistance);
    return;
  }
  if (this->NearDistance != distance)
  {
    this->NearDistance = distance;
    this->Modified();
  }
  this->SetParameterization(BY_NEAR_DISTANCE);
}

void vtkPerspectiveShadowMapWarp::SetFocusPoint(double share)
{
  if (!(share > 0 && share <= 1))
  {
    vtkErrorMacro("SetFocusPoint(" << share << "): expected a share above 0, up to 1; keeping "
                                   << this->FocusPoint);
    return;
  }
  if (this->FocusPoint != share)
  {
    this->FocusPoint = share;
    this->Modified();
  }
}

void vtkPerspectiveShadowMapWarp::SetResolutionSplit(int split)
{
  if (split < SPLIT_SQUARE || split > SPLIT_BY_RATIO)
  {
    vtkErrorMacro("SetResolutionSplit(" << split
                                        << "): expected SPLIT_SQUARE (0), SPLIT_CRITICAL (1), "
                                           "SPLIT_AUTOMATIC (2) or SPLIT_BY_RATIO (3); keeping "
                                        << this->ResolutionSplit);
    return;
  }
  if (this->ResolutionSplit != split)
  {
    this->ResolutionSplit = split;
    this->Modified();
  }
}

void vtkPerspectiveShadowMapWarp::SetResolutionRatio(double ratio)
{
  if (!(ratio >= 1.0 / 16 && ratio <= 16))
  {
    vtkErrorMacro("SetResolutionRatio(" << ratio << "): expected a number from 1/16 to 16; keeping "
                                        << this->ResolutionRatio);
    return;
  }
  if (this->ResolutionRatio != ratio)
  {
    this->ResolutionRatio = ratio;
    this->Modified();
  }
  this->SetResolutionSplit(SPLIT_BY_RATIO);
}

std::unique_ptr<rtw::WarpStage> vtkPerspectiveShadowMapWarp::MakeStage()
{
  const auto split = [this] {
    using Split = rtw::SplitSettings;
    switch (this->ResolutionSplit)
    {
      case SPLIT_CRITICAL:
        return Split{ Split::Critical, 1 };
      case SPLIT_AUTOMATIC:
        return Split{ Split::LeastError, 1 };
      case SPLIT_BY_RATIO:
        return Split{ Split::Given, this->ResolutionRatio };
      default:
        return Split{ Split::Given, 1 };
    }
  };
  const auto choice = [this] {
    using Choice = rtw::PerspectiveChoice;
    switch (this->Parameterization)
    {
      case PSM:
        return Choice{ Choice::Eta, 1 };
      case TSM:
        return Choice{ Choice::FocusPoint, this->FocusPoint };
      case UNWARPED:
        return Choice{ Choice::Eta, -1 };
      case BY_ETA:
        return Choice{ Choice::Eta, this->Eta };
      case BY_NEAR_DISTANCE:
        return Choice{ Choice::Near, this->NearDistance };
      default:
        return Choice{ Choice::Eta, 0 };
    }
  };
  return std::make_unique<rtw::PerspectiveWarpStage>(choice, split);
}

void vtkPerspectiveShadowMapWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Parameterization: " << this->Parameterization << "\n";
  os << indent << "Eta: " << this->Eta << "\n";
  os << indent << "NearDistance: " << this->NearDistance << "\n";
  os << indent << "FocusPoint: " << this->FocusPoint << "\n";
  os << indent << "ResolutionSplit: " << this->ResolutionSplit << "\n";
  os << indent << "ResolutionRatio: " << this->ResolutionRatio << "\n";
}
