// SPDX-License-Identifier: BSD-3-Clause
// The axes, statistics and images of vtkAdaptiveShadowMapPass.
#include "vtkAdaptiveShadowMapPass.h"

#include "Passes/rtwAdaptiveShadowMapInternals.h"

#include "vtkAdaptiveShadowMapBakerPass.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkShadowMapPartition.h"
#include "vtkShadowMapWarp.h"

#include <algorithm>
#include <utility>

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

void vtkAdaptiveShadowMapPass::SetMaskSource(std::unique_ptr<rtw::MaskSource> source)
{
  this->DropRightEye(this->Shadows->Window);
  this->Shadows->Pipeline.SetMaskSource(std::move(source));
  this->Modified();
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
  int drawn = 0;
  for (int layer = 0; layer < this->GetNumberOfLightLayers(light); ++layer)
  {
    drawn += this->GetNumberOfCastersDrawn(light, layer);
  }
  return drawn;
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersDrawn(int light, int layer)
{
  const int index = this->Shadows->LayerOf(light, layer);
  return index < 0 ? 0 : static_cast<int>(this->Shadows->Pipeline.ReadCasterCounts(index).Drawn);
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersCulled(int light)
{
  int culled = 0;
  for (int layer = 0; layer < this->GetNumberOfLightLayers(light); ++layer)
  {
    culled += this->GetNumberOfCastersCulled(light, layer);
  }
  return culled;
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersCulled(int light, int layer)
{
  const int index = this->Shadows->LayerOf(light, layer);
  return index < 0 ? 0 : static_cast<int>(this->Shadows->Pipeline.ReadCasterCounts(index).Culled);
}

int vtkAdaptiveShadowMapPass::GetNumberOfLightLayers(int light)
{
  return this->Shadows->Has(light) ? this->Shadows->Pipeline.GetLayerFrames()[0].Parts : 0;
}

bool vtkAdaptiveShadowMapPass::GetLayerDepthRange(int light, int layer, double range[2])
{
  Internals& my = *this->Shadows;
  const int index = my.LayerOf(light, layer);
  if (index < 0 || !my.MakeCurrent())
  {
    return false;
  }
  const glm::dvec2 interval = my.Pipeline.ReadInterval(index);
  range[0] = interval.x;
  range[1] = interval.y;
  return true;
}

vtkTypeInt64 vtkAdaptiveShadowMapPass::GetShadowMemory()
{
  return this->Shadows->Pipeline.GetStatistics().ShadowMemory +
    (this->OtherEye ? this->OtherEye->Pipeline.GetStatistics().ShadowMemory : 0);
}

double vtkAdaptiveShadowMapPass::GetMaximumEffectiveResolution(int light, int axis)
{
  if (!this->Shadows->Has(light) || axis < 0 || axis > 1)
  {
    return 0;
  }
  double most = 0;
  for (int layer = 0; layer < this->GetNumberOfLightLayers(light); ++layer)
  {
    const int index = this->Shadows->LayerOf(light, layer);
    most = std::max(most, this->Shadows->Pipeline.ReadMaximumEffectiveResolution(index)[axis]);
  }
  return most;
}

void vtkAdaptiveShadowMapPass::SetTimeStages(bool time)
{
  this->Shadows->Pipeline.GetTimers().SetEnabled(time);
  if (this->OtherEye)
  {
    this->OtherEye->Pipeline.GetTimers().SetEnabled(time);
  }
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
  const int index = my.LayerOf(light, layer);
  my.MapImage = index >= 0 && my.Pipeline.HasOwnLayers() && my.MakeCurrent()
    ? rtw::ReadShadowMap(my.Pipeline.GetLayers(), index)
    : nullptr;
  return my.MapImage;
}

vtkImageData* vtkAdaptiveShadowMapPass::GetWarpImage(int light, int layer)
{
  Internals& my = *this->Shadows;
  const int index = my.LayerOf(light, layer);
  my.WarpImage = index >= 0 && my.MakeCurrent()
    ? rtw::ReadWarp(my.Pipeline.GetTable(), index, my.Pipeline.GetShape().Kind)
    : nullptr;
  return my.WarpImage;
}

bool vtkAdaptiveShadowMapPass::GetLightPlaneMatrix(int light, int layer, vtkMatrix4x4* worldToPlane)
{
  Internals& my = *this->Shadows;
  const int index = my.LayerOf(light, layer);
  if (!worldToPlane || index < 0 || !my.MakeCurrent())
  {
    return false;
  }
  const glm::dmat4 matrix =
    my.Pipeline.GetFrames()[light].WorldToFocus(my.Pipeline.GetTable().ReadFocus(index));
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
  os << indent << "Partition:\n";
  this->Partition->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Warp:\n";
  this->Warp->PrintSelf(os, indent.GetNextIndent());
}
