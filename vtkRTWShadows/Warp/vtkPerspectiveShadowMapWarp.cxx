// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPerspectiveShadowMapWarp.h"

#include "rtwPerspectiveWarpStage.h"

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

std::unique_ptr<rtw::WarpStage> vtkPerspectiveShadowMapWarp::MakeStage()
{
  return std::make_unique<rtw::PerspectiveWarpStage>([this] {
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
  });
}

void vtkPerspectiveShadowMapWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Parameterization: " << this->Parameterization << "\n";
  os << indent << "Eta: " << this->Eta << "\n";
  os << indent << "NearDistance: " << this->NearDistance << "\n";
  os << indent << "FocusPoint: " << this->FocusPoint << "\n";
}
