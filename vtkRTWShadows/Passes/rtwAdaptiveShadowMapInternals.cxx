// SPDX-License-Identifier: BSD-3-Clause
#include "rtwAdaptiveShadowMapInternals.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkShadowMapPartition.h"
#include "vtkShadowMapWarp.h"
#include "vtkTextureUnitManager.h"

#include <utility>

bool vtkAdaptiveShadowMapPass::Internals::MakeCurrent()
{
  if (!this->Window)
  {
    return false;
  }
  this->Window->MakeCurrent();
  return this->Window->IsCurrent();
}

void vtkAdaptiveShadowMapPass::Internals::UseWarp(vtkShadowMapWarp* warp)
{
  if (this->Warp != warp)
  {
    // The old stage asks the old warp for its settings, so the stage goes first.
    this->Pipeline.SetWarp(warp->MakeStage());
    this->Warp = warp;
  }
}

void vtkAdaptiveShadowMapPass::Internals::UsePartition(vtkShadowMapPartition* partition)
{
  if (this->Partition != partition)
  {
    this->Pipeline.SetPartition(partition->MakeStage());
    this->Partition = partition;
  }
}

std::uint64_t vtkAdaptiveShadowMapPass::Internals::Sign(
  vtkMTimeType warpTime, vtkMTimeType partitionTime) const
{
  const rtw::PipelineOptions& o = this->Options;
  std::uint64_t signature = rtw::Mix(std::uint64_t(1), std::uint64_t(warpTime));
  signature = rtw::Mix(signature, std::uint64_t(partitionTime));
  signature = rtw::Mix(signature, std::uint64_t(o.Resolution));
  signature = rtw::Mix(signature, std::uint64_t(o.ViewSampleStride));
  signature = rtw::Mix(signature, std::uint64_t(o.SamplesAPixel));
  signature = rtw::Mix(signature, std::uint64_t(o.Shape.Filter));
  signature = rtw::Mix(rtw::Mix(signature, std::uint64_t(o.Shape.DepthTest)), o.Lookup.Bias);
  signature = rtw::Mix(rtw::Mix(signature, o.Lookup.FilterTexels), o.Lookup.FilterWorld);
  signature = rtw::Mix(signature, o.Casters.EdgeLength);
  return rtw::Mix(signature,
    std::uint64_t(o.FocusOnView) | std::uint64_t(o.Casters.Cull) << 1 | std::uint64_t(o.Masked) << 2 |
      std::uint64_t(o.PreviousFrame) << 3 | std::uint64_t(o.Lookup.FilterJitter) << 4 |
      std::uint64_t(o.Casters.Bends) << 8);
}

vtkAdaptiveShadowMapPass::Internals::Attachment::Attachment(Internals& internals, vtkAdaptiveShadowMapPass* pass,
  std::vector<vtkProp*> props, rtw::Phase phase, int layer)
  : My(internals)
  , Pass(pass)
  , Props(std::move(props))
{
  vtkTextureUnitManager* manager = this->My.Window->GetTextureUnitManager();
  const bool hasGrid = this->My.Pipeline.GetShape().Kind == rtw::WarpKind::Grid;
  const bool hasSamples = this->My.Options.SamplesAPixel > 1;
  this->Needed = std::size_t(4) + (hasGrid ? 1 : 0) + (hasSamples ? 2 : 0);
  while (this->Units.size() < this->Needed)
  {
    const int unit = manager->Allocate();
    if (unit < 0)
    {
      return;
    }
    this->Units.push_back(unit);
  }
  if (phase != rtw::Phase::Picture)
  {
    this->Alone.emplace(this->Props);
  }
  this->My.Uniforms = this->My.Pipeline.MakeUniforms(this->My.Options);
  rtw::ReceiverUniforms& uniforms = this->My.Uniforms;
  const std::vector<rtw::LightFrame>& frames = this->My.Pipeline.GetLayerFrames();
  uniforms.CurrentPhase = phase;
  uniforms.Layer = layer;
  uniforms.LightParallel =
    frames[layer % frames.size()].Light.Kind == rtw::LightKind::Directional;
  uniforms.WarpUnit = this->Units[0];
  uniforms.DepthUnit = this->Units[1];
  uniforms.GradientUnit = this->Units[2];
  uniforms.MaskUnit = this->Units[3];
  uniforms.GridUnit = this->Units.back();
  uniforms.BitsUnit = this->Units[hasSamples ? 4 : 3];
  uniforms.ManyUnit = this->Units[hasSamples ? 5 : 3];
  this->My.Pipeline.BindTextures(uniforms, phase == rtw::Phase::Picture);
  this->My.Window->GetState()->ResetGLActiveTexture();
  for (vtkProp* prop : this->Props)
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    if (!keys)
    {
      keys = vtkInformation::New();
      prop->SetPropertyKeys(keys);
      keys->FastDelete();
    }
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this->Pass);
  }
}

vtkAdaptiveShadowMapPass::Internals::Attachment::~Attachment()
{
  vtkTextureUnitManager* manager = this->My.Window->GetTextureUnitManager();
  if (this->IsComplete())
  {
    this->My.Pipeline.UnbindTextures(this->My.Uniforms);
    this->My.Window->GetState()->ResetGLActiveTexture();
    for (vtkProp* prop : this->Props)
    {
      vtkInformation* keys = prop->GetPropertyKeys();
      keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this->Pass);
      if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
      {
        keys->Remove(vtkOpenGLRenderPass::RenderPasses());
      }
    }
  }
  for (const int unit : this->Units)
  {
    manager->Free(unit);
  }
}
