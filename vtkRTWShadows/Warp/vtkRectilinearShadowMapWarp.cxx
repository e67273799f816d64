// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRectilinearShadowMapWarp.h"

#include "rtwRectilinearWarpStage.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRectilinearShadowMapWarp);

static_assert(vtkRectilinearShadowMapWarp::DISTANCE_TO_EYE == int(rtw::DistanceToEye) &&
    vtkRectilinearShadowMapWarp::SURFACE_NORMAL == int(rtw::SurfaceNormal) &&
    vtkRectilinearShadowMapWarp::SQRT_DEMAND == int(rtw::SqrtDemand),
  "one set of bits");

vtkRectilinearShadowMapWarp::vtkRectilinearShadowMapWarp() = default;
vtkRectilinearShadowMapWarp::~vtkRectilinearShadowMapWarp() = default;

void vtkRectilinearShadowMapWarp::SetImportance(int functions)
{
  constexpr int all = DESIRED_VIEW | DISTANCE_TO_EYE | SURFACE_NORMAL | SQRT_DEMAND;
  if (functions <= 0 || (functions & ~all) != 0)
  {
    vtkErrorMacro("SetImportance(" << functions
                                   << "): expected a sum of DESIRED_VIEW (1), DISTANCE_TO_EYE (2), "
                                      "SURFACE_NORMAL (4) and SQRT_DEMAND (8); keeping "
                                   << this->Importance);
    return;
  }
  if (this->Importance != functions)
  {
    this->Importance = functions;
    this->Modified();
  }
}

void vtkRectilinearShadowMapWarp::SetFinite(
  double& member, double value, double low, double high, const char* name)
{
  if (!std::isfinite(value))
  {
    vtkErrorMacro("Set" << name << "(" << value << "): expected a number from " << low << " to "
                        << high << "; keeping " << member);
    return;
  }
  value = std::clamp(value, low, high);
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

void vtkRectilinearShadowMapWarp::SetBlurSigma(double sigma)
{
  this->SetFinite(this->BlurSigma, sigma, 0, 64, "BlurSigma");
}

void vtkRectilinearShadowMapWarp::SetImportanceFloor(double share)
{
  this->SetFinite(this->ImportanceFloor, share, 0.0001, 1, "ImportanceFloor");
}

std::unique_ptr<rtw::WarpStage> vtkRectilinearShadowMapWarp::MakeStage()
{
  return std::make_unique<rtw::RectilinearWarpStage>([this] {
    return rtw::RectilinearSettings{ this->Importance, this->ImportanceResolution,
      this->BlurSigma, this->ImportanceFloor };
  });
}

void vtkRectilinearShadowMapWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Importance: " << this->Importance << "\n";
  os << indent << "ImportanceResolution: " << this->ImportanceResolution << "\n";
  os << indent << "BlurSigma: " << this->BlurSigma << "\n";
  os << indent << "ImportanceFloor: " << this->ImportanceFloor << "\n";
}
