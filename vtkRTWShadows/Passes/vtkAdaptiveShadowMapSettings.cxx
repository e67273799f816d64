// SPDX-License-Identifier: BSD-3-Clause
// The properties and statistics of vtkAdaptiveShadowMapPass.
#include "vtkAdaptiveShadowMapPass.h"

#include "rtwAdaptiveShadowMapInternals.h"

#include "vtkAdaptiveShadowMapBakerPass.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkShadowMapPartition.h"
#include "vtkShadowMapWarp.h"

#include <algorithm>
#include <cmath>

void vtkAdaptiveShadowMapPass::SetResolution(unsigned int resolution)
{
  this->ShadowMapBakerPass->SetResolution(resolution);
}

unsigned int vtkAdaptiveShadowMapPass::GetResolution()
{
  return this->ShadowMapBakerPass->GetResolution();
}

bool vtkAdaptiveShadowMapPass::Choose(
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

void vtkAdaptiveShadowMapPass::SetFilter(int filter)
{
  this->Choose(this->Filter, filter, filter >= NEAREST && filter <= SOFT, "Filter",
    "NEAREST (0), BILINEAR (1), PCF (2) or SOFT (3)");
}

void vtkAdaptiveShadowMapPass::SetFilterRadius(double radius)
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

void vtkAdaptiveShadowMapPass::SetDepthTest(int test)
{
  this->Choose(this->DepthTest, test,
    test == DUAL || test == RECEIVER_PLANE || test == CONSTANT_BIAS, "DepthTest",
    "DUAL (0), RECEIVER_PLANE (1) or CONSTANT_BIAS (2)");
}

void vtkAdaptiveShadowMapPass::SetRasterization(int rasterization)
{
  this->Choose(this->Rasterization, rasterization,
    rasterization >= LINEAR && rasterization <= AUTOMATIC, "Rasterization",
    "LINEAR (0), TESSELLATED (1), EXACT (2) or AUTOMATIC (3)");
}

void vtkAdaptiveShadowMapPass::SetLightPlaneTurn(int turn)
{
  this->Choose(this->LightPlaneTurn, turn, turn >= TURN_OFF && turn <= TURN_AUTOMATIC,
    "LightPlaneTurn", "TURN_OFF (0), TURN_VIEW_ALIGNED (1) or TURN_AUTOMATIC (2)");
}

void vtkAdaptiveShadowMapPass::SetViewSampleSource(int source)
{
  this->Choose(this->ViewSampleSource, source, source == PREPASS || source == PREVIOUS_FRAME,
    "ViewSampleSource", "PREPASS (0) or PREVIOUS_FRAME (1)");
}

void vtkAdaptiveShadowMapPass::SetShare(
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

void vtkAdaptiveShadowMapPass::SetMaximumEdgeLength(double share)
{
  this->SetShare(this->MaximumEdgeLength, share, 0.001, "MaximumEdgeLength");
}

void vtkAdaptiveShadowMapPass::SetConstantBias(double share)
{
  this->SetShare(this->ConstantBias, share, 0.0, "ConstantBias");
}

void vtkAdaptiveShadowMapPass::SetPartition(vtkShadowMapPartition* partition)
{
  if (!partition)
  {
    vtkErrorMacro("SetPartition(null): expected a vtkShadowMapPartition; keeping the one that is set");
    return;
  }
  if (this->Partition != partition)
  {
    this->Partition = partition;
    this->Modified();
  }
}

vtkShadowMapPartition* vtkAdaptiveShadowMapPass::GetPartition()
{
  return this->Partition;
}

void vtkAdaptiveShadowMapPass::SetWarp(vtkShadowMapWarp* warp)
{
  if (!warp)
  {
    vtkErrorMacro("SetWarp(null): expected a vtkShadowMapWarp; keeping the one that is set");
    return;
  }
  if (this->Warp != warp)
  {
    this->Warp = warp;
    this->Modified();
  }
}

vtkShadowMapWarp* vtkAdaptiveShadowMapPass::GetWarp()
{
  return this->Warp;
}

int vtkAdaptiveShadowMapPass::GetNumberOfShadowLights()
{
  return static_cast<int>(this->Shadows->Pipeline.GetFrames().size());
}

int vtkAdaptiveShadowMapPass::GetNumberOfLightsSkipped()
{
  return this->Shadows->Lights.Skipped;
}

int vtkAdaptiveShadowMapPass::GetNumberOfLayersDrawn()
{
  return this->Shadows->Pipeline.GetStatistics().LayersDrawn;
}

int vtkAdaptiveShadowMapPass::GetNumberOfLayersReused()
{
  return this->Shadows->Pipeline.GetStatistics().LayersReused;
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersDrawn(int light)
{
  return this->Shadows->Has(light)
    ? static_cast<int>(this->Shadows->Pipeline.ReadCasterCounts(light).Drawn)
    : 0;
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersCulled(int light)
{
  return this->Shadows->Has(light)
    ? static_cast<int>(this->Shadows->Pipeline.ReadCasterCounts(light).Culled)
    : 0;
}

vtkTypeInt64 vtkAdaptiveShadowMapPass::GetShadowMemory()
{
  return this->Shadows->Pipeline.GetStatistics().ShadowMemory;
}

double vtkAdaptiveShadowMapPass::GetMaximumEffectiveResolution(int light, int axis)
{
  if (!this->Shadows->Has(light) || axis < 0 || axis > 1)
  {
    return 0;
  }
  return this->Shadows->Pipeline.ReadMaximumEffectiveResolution(light)[axis];
}

void vtkAdaptiveShadowMapPass::SetTimeStages(bool time)
{
  this->Shadows->Pipeline.GetTimers().SetEnabled(time);
}

bool vtkAdaptiveShadowMapPass::GetTimeStages()
{
  return this->Shadows->Pipeline.GetTimers().GetEnabled();
}

int vtkAdaptiveShadowMapPass::GetNumberOfStages()
{
  return this->Shadows->Pipeline.GetTimers().GetNumberOfStages();
}

const char* vtkAdaptiveShadowMapPass::GetStageName(int stage)
{
  const bool exists = stage >= 0 && stage < this->GetNumberOfStages();
  return exists ? this->Shadows->Pipeline.GetTimers().GetName(stage) : nullptr;
}

double vtkAdaptiveShadowMapPass::GetStageMilliseconds(int stage)
{
  const bool exists = stage >= 0 && stage < this->GetNumberOfStages();
  return exists ? this->Shadows->Pipeline.GetTimers().GetMilliseconds(stage) : 0;
}

vtkImageData* vtkAdaptiveShadowMapPass::GetShadowMask(int light)
{
  Internals& my = *this->Shadows;
  my.MaskImage = nullptr;
  if (my.Has(light) && my.Renderer && my.MakeCurrent())
  {
    vtkRenderer* renderer = my.Renderer;
    my.MaskImage = rtw::ReadMask(
      my.Pipeline.GetMask(my.Options, [this, renderer] { this->DrawViewSamples(renderer); }), light);
  }
  return my.MaskImage;
}

vtkImageData* vtkAdaptiveShadowMapPass::GetShadowMapImage(int light, int layer)
{
  Internals& my = *this->Shadows;
  my.MapImage = my.Has(light) && layer == 0 && my.MakeCurrent()
    ? rtw::ReadShadowMap(my.Pipeline.GetLayers(), light)
    : nullptr;
  return my.MapImage;
}

vtkImageData* vtkAdaptiveShadowMapPass::GetWarpImage(int light, int layer)
{
  Internals& my = *this->Shadows;
  my.WarpImage = my.Has(light) && layer == 0 && my.MakeCurrent()
    ? rtw::ReadWarp(my.Pipeline.GetTable(), light)
    : nullptr;
  return my.WarpImage;
}

bool vtkAdaptiveShadowMapPass::GetLightPlaneMatrix(int light, int layer, vtkMatrix4x4* worldToPlane)
{
  Internals& my = *this->Shadows;
  if (!worldToPlane || !my.Has(light) || layer != 0 || !my.MakeCurrent())
  {
    return false;
  }
  const glm::dmat4 matrix =
    my.Pipeline.GetFrames()[light].WorldToFocus(my.Pipeline.GetTable().ReadFocus(light));
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      worldToPlane->SetElement(row, column, matrix[column][row]);
    }
  }
  return true;
}

void vtkAdaptiveShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
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
  os << indent << "Partition:\n";
  this->Partition->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Warp:\n";
  this->Warp->PrintSelf(os, indent.GetNextIndent());
}
