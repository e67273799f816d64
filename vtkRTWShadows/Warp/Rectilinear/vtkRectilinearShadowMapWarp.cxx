// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRectilinearShadowMapWarp.h"

#include "Warp/Rectilinear/rtwRectilinearWarpStage.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRectilinearShadowMapWarp);

static_assert(vtkRectilinearShadowMapWarp::DISTANCE_TO_EYE == int(rtw::DistanceToEye) &&
    vtkRectilinearShadowMapWarp::SURFACE_NORMAL == int(rtw::SurfaceNormal) &&
    vtkRectilinearShadowMapWarp::SQRT_DEMAND == int(rtw::SqrtDemand) &&
    vtkRectilinearShadowMapWarp::SHADOW_EDGE == int(rtw::ShadowEdge) &&
    vtkRectilinearShadowMapWarp::CENTRE_OF_INTEREST == int(rtw::CentreOfInterest) &&
    vtkRectilinearShadowMapWarp::USER_FUNCTION == int(rtw::UserFunction) &&
    vtkRectilinearShadowMapWarp::FOOTPRINT == int(rtw::Footprint) &&
    vtkRectilinearShadowMapWarp::SAMPLE_COUNT == int(rtw::SampleCount),
  "one set of bits");
static_assert(vtkRectilinearShadowMapWarp::FORWARD == int(rtw::Analysis::Forward) &&
    vtkRectilinearShadowMapWarp::BACKWARD == int(rtw::Analysis::Backward) &&
    vtkRectilinearShadowMapWarp::HYBRID == int(rtw::Analysis::Hybrid),
  "one order");

vtkRectilinearShadowMapWarp::vtkRectilinearShadowMapWarp() = default;
vtkRectilinearShadowMapWarp::~vtkRectilinearShadowMapWarp() = default;

void vtkRectilinearShadowMapWarp::SetImportance(int functions)
{
  if (functions <= 0 || (functions & ~rtw::AllFunctions) != 0)
  {
    vtkErrorMacro("SetImportance("
      << functions
      << "): expected a sum of DESIRED_VIEW (1), DISTANCE_TO_EYE (2), "
         "SURFACE_NORMAL (4), SQRT_DEMAND (8), SHADOW_EDGE (16), CENTRE_OF_INTEREST (32), "
         "USER_FUNCTION (64), FOOTPRINT (128) and SAMPLE_COUNT (256); keeping "
      << this->Importance);
    return;
  }
  if (this->Importance != functions)
  {
    this->Importance = functions;
    this->Modified();
  }
}

void vtkRectilinearShadowMapWarp::Choose(
  int& member, int value, int most, const char* name, const char* expected)
{
  if (value < 0 || value > most)
  {
    vtkErrorMacro(
      "Set" << name << "(" << value << "): expected " << expected << "; keeping " << member);
  }
  else if (member != value)
  {
    member = value;
    this->Modified();
  }
}

void vtkRectilinearShadowMapWarp::SetAnalysis(int analysis)
{
  this->Choose(
    this->Analysis, analysis, HYBRID, "Analysis", "FORWARD (0), BACKWARD (1) or HYBRID (2)");
}

void vtkRectilinearShadowMapWarp::SetInterest(int interest)
{
  this->Choose(this->Interest, interest, SPHERE, "Interest", "VIEW (0) or SPHERE (1)");
}

void vtkRectilinearShadowMapWarp::SetInterestCentre(double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    const double* kept = this->InterestCentre;
    vtkErrorMacro("SetInterestCentre("
      << x << ", " << y << ", " << z << "): expected finite world coordinates; keeping " << kept[0]
      << ", " << kept[1] << ", " << kept[2]);
    return;
  }
  const double centre[3] = { x, y, z };
  if (!std::equal(centre, centre + 3, this->InterestCentre))
  {
    std::copy_n(centre, 3, this->InterestCentre);
    this->Modified();
  }
}

void vtkRectilinearShadowMapWarp::SetInterestCentre(const double centre[3])
{
  this->SetInterestCentre(centre[0], centre[1], centre[2]);
}

void vtkRectilinearShadowMapWarp::SetUserFunction(const char* glsl)
{
  const std::string code = glsl ? glsl : "";
  if (this->UserFunction != code)
  {
    this->UserFunction = code;
    this->IsRefused = false;
    this->Modified();
  }
}

// Each pass that this warp serves compiles the user's function by itself: the error is reported
// once.
void vtkRectilinearShadowMapWarp::Refuse(const std::string& log)
{
  if (this->IsRefused)
  {
    return;
  }
  this->IsRefused = true;
  if ((this->Importance & USER_FUNCTION) == 0)
  {
    vtkErrorMacro("the driver refuses Importance "
      << this->Importance << " with Analysis " << this->Analysis << ":\n"
      << log << "The last that it took stay in force.");
  }
  else
  {
    vtkErrorMacro("UserFunction doesn't compile:\n"
      << this->UserFunction << "\n"
      << log
      << "Source 0 is the function. The last one that did compile stays in force; correct it by "
         "SetUserFunction().");
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

void vtkRectilinearShadowMapWarp::SetTemporalBlending(double share)
{
  this->SetFinite(this->TemporalBlending, share, 0, 0.99, "TemporalBlending");
}

void vtkRectilinearShadowMapWarp::SetEdgeThreshold(double share)
{
  this->SetFinite(this->EdgeThreshold, share, 0, 1, "EdgeThreshold");
}

void vtkRectilinearShadowMapWarp::SetSurfaceNormalBonus(double bonus)
{
  this->SetFinite(this->SurfaceNormalBonus, bonus, 0, 1000, "SurfaceNormalBonus");
}

void vtkRectilinearShadowMapWarp::SetInterestRadius(double radius)
{
  this->SetFinite(this->InterestRadius, radius, 1e-30, 1e30, "InterestRadius");
}

void vtkRectilinearShadowMapWarp::SetInterestViewRadius(double share)
{
  this->SetFinite(this->InterestViewRadius, share, 0.001, 10, "InterestViewRadius");
}

void vtkRectilinearShadowMapWarp::SetInterestBonus(double bonus)
{
  this->SetFinite(this->InterestBonus, bonus, 0, 1000, "InterestBonus");
}

std::unique_ptr<rtw::WarpStage> vtkRectilinearShadowMapWarp::MakeStage()
{
  const auto settings = [this] {
    rtw::RectilinearSettings s;
    s.Importance.Functions = this->Importance;
    s.Importance.Method = static_cast<rtw::Analysis>(this->Analysis);
    s.Importance.NormalBonus = this->SurfaceNormalBonus;
    s.Importance.EdgeThreshold = this->EdgeThreshold;
    s.Importance.InterestInView = this->Interest == VIEW;
    std::copy_n(this->InterestCentre, 3, &s.Importance.InterestCentre[0]);
    s.Importance.InterestRadius = this->InterestRadius;
    s.Importance.InterestShare = this->InterestViewRadius;
    s.Importance.InterestBonus = this->InterestBonus;
    s.Importance.Code = this->UserFunction;
    s.LightImageSize = this->LightImageResolution;
    s.Cells = this->ImportanceResolution;
    s.Sigma = this->BlurSigma;
    s.Floor = this->ImportanceFloor;
    s.Blending = this->TemporalBlending;
    s.Snapping = this->Snapping;
    s.CullsCells = this->CullEmptyCells;
    return s;
  };
  return std::make_unique<rtw::RectilinearWarpStage>(
    settings, [this](const std::string& log) { this->Refuse(log); });
}

void vtkRectilinearShadowMapWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Importance: " << this->Importance << "\n";
  os << indent << "Analysis: " << this->Analysis << "\n";
  os << indent << "LightImageResolution: " << this->LightImageResolution << "\n";
  os << indent << "EdgeThreshold: " << this->EdgeThreshold << "\n";
  os << indent << "SurfaceNormalBonus: " << this->SurfaceNormalBonus << "\n";
  os << indent << "Interest: " << this->Interest << "\n";
  os << indent << "InterestCentre: " << this->InterestCentre[0] << ", " << this->InterestCentre[1]
     << ", " << this->InterestCentre[2] << "\n";
  os << indent << "InterestRadius: " << this->InterestRadius << "\n";
  os << indent << "InterestViewRadius: " << this->InterestViewRadius << "\n";
  os << indent << "InterestBonus: " << this->InterestBonus << "\n";
  os << indent << "UserFunction: " << this->UserFunction << "\n";
  os << indent << "ImportanceResolution: " << this->ImportanceResolution << "\n";
  os << indent << "BlurSigma: " << this->BlurSigma << "\n";
  os << indent << "ImportanceFloor: " << this->ImportanceFloor << "\n";
  os << indent << "TemporalBlending: " << this->TemporalBlending << "\n";
  os << indent << "Snapping: " << this->Snapping << "\n";
  os << indent << "CullEmptyCells: " << this->CullEmptyCells << "\n";
}
