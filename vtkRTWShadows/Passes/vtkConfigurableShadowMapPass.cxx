// SPDX-License-Identifier: BSD-3-Clause
#include "vtkConfigurableShadowMapPass.h"

#include "vtkShadowMapBakerPass.h"

#include <algorithm>
#include <cmath>

vtkConfigurableShadowMapPass::vtkConfigurableShadowMapPass() = default;
vtkConfigurableShadowMapPass::~vtkConfigurableShadowMapPass() = default;

void vtkConfigurableShadowMapPass::SetResolution(unsigned int resolution)
{
  this->ShadowMapBakerPass->SetResolution(resolution);
}

unsigned int vtkConfigurableShadowMapPass::GetResolution()
{
  return this->ShadowMapBakerPass->GetResolution();
}

bool vtkConfigurableShadowMapPass::Choose(
  int& member, int value, bool valid, const char* property, const char* choices)
{
  if (!valid)
  {
    vtkErrorMacro("Set" << property << "(" << value << "): expected " << choices << "; keeping "
                        << member);
    return false;
  }
  if (member != value)
  {
    member = value;
    this->Modified();
  }
  return true;
}

void vtkConfigurableShadowMapPass::SetFilter(int filter)
{
  this->Choose(this->Filter, filter, filter >= NEAREST && filter <= SOFT, "Filter",
    "NEAREST (0), BILINEAR (1), PCF (2) or SOFT (3)");
}

void vtkConfigurableShadowMapPass::SetFilterRadius(double radius)
{
  if (!(radius >= 0 && radius <= 1e30))
  {
    vtkErrorMacro("SetFilterRadius(" << radius << "): expected a number from 0 to 1e30; keeping "
                                     << this->FilterRadius);
    return;
  }
  if (this->FilterRadius != radius)
  {
    this->FilterRadius = radius;
    this->Modified();
  }
}

void vtkConfigurableShadowMapPass::SetDepthTest(int test)
{
  this->Choose(this->DepthTest, test,
    test == DUAL || test == RECEIVER_PLANE || test == CONSTANT_BIAS, "DepthTest",
    "DUAL (0), RECEIVER_PLANE (1) or CONSTANT_BIAS (2)");
}

void vtkConfigurableShadowMapPass::SetRasterization(int rasterization)
{
  this->Choose(this->Rasterization, rasterization,
    rasterization >= LINEAR && rasterization <= AUTOMATIC, "Rasterization",
    "LINEAR (0), TESSELLATED (1), EXACT (2) or AUTOMATIC (3)");
}

void vtkConfigurableShadowMapPass::SetLightPlaneTurn(int turn)
{
  this->Choose(this->LightPlaneTurn, turn, turn >= TURN_OFF && turn <= TURN_MINIMAL_FRUSTUM,
    "LightPlaneTurn",
    "TURN_OFF (0), TURN_VIEW_ALIGNED (1), TURN_AUTOMATIC (2) or TURN_MINIMAL_FRUSTUM (3)");
}

void vtkConfigurableShadowMapPass::SetViewSampleSource(int source)
{
  this->Choose(this->ViewSampleSource, source, source == PREPASS || source == PREVIOUS_FRAME,
    "ViewSampleSource", "PREPASS (0) or PREVIOUS_FRAME (1)");
}

void vtkConfigurableShadowMapPass::SetShare(
  double& member, double share, double least, const char* property)
{
  if (!std::isfinite(share))
  {
    vtkErrorMacro("Set" << property << "(" << share << "): expected a number from " << least
                        << " to 1; keeping " << member);
    return;
  }
  share = std::clamp(share, least, 1.0);
  if (member != share)
  {
    member = share;
    this->Modified();
  }
}

void vtkConfigurableShadowMapPass::SetMaximumEdgeLength(double share)
{
  this->SetShare(this->MaximumEdgeLength, share, 0.001, "MaximumEdgeLength");
}

void vtkConfigurableShadowMapPass::SetConstantBias(double share)
{
  this->SetShare(this->ConstantBias, share, 0.0, "ConstantBias");
}

void vtkConfigurableShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->GetResolution() << "\n";
  os << indent << "FocusOnView: " << this->FocusOnView << "\n";
  os << indent << "Filter: " << this->Filter << "\n";
  os << indent << "FilterRadius: " << this->FilterRadius << "\n";
  os << indent << "FilterJitter: " << this->FilterJitter << "\n";
  os << indent << "DepthTest: " << this->DepthTest << "\n";
  os << indent << "ConstantBias: " << this->ConstantBias << "\n";
  os << indent << "Rasterization: " << this->Rasterization << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "LightPlaneTurn: " << this->LightPlaneTurn << "\n";
  os << indent << "ViewSampleSource: " << this->ViewSampleSource << "\n";
  os << indent << "ViewSampleStride: " << this->ViewSampleStride << "\n";
  os << indent << "Caching: " << this->Caching << "\n";
  os << indent << "CullCasters: " << this->CullCasters << "\n";
}
