// SPDX-License-Identifier: BSD-3-Clause
// What a frame has for the shaders of receivers.
#include "rtwShadowPipeline.h"

namespace rtw
{
ReceiverUniforms ShadowPipeline::MakeUniforms(const PipelineOptions& options) const
{
  ReceiverUniforms uniforms;
  uniforms.Cells = this->Table.GetCells();
  uniforms.Resolution = this->Table.GetResolution();
  uniforms.MapSize = this->Table.GetMapSize();
  uniforms.GridLayers = this->Table.GetGridLayers();
  uniforms.OtherLayers = this->OtherLayers;
  uniforms.RayStep = glm::vec3(ViewSampler::RayStep(this->Viewed));
  uniforms.DepthToSample = glm::vec2(ViewSampler::DepthToSample(this->Viewed));
  if (options.SamplesAPixel > 1)
  {
    uniforms.Points = this->Sampler.GetOffsets();
    uniforms.ParallelView = glm::vec2(ViewSampler::SampleToDistance(this->Viewed));
    uniforms.HiddenBeyond = float(DepthRounding * this->SceneSize);
  }
  uniforms.Lights =
    ReceiverLights::Make(this->Frames, this->Viewed, options.Lookup, this->SceneSize);
  return uniforms;
}

void ShadowPipeline::BindTextures(const ReceiverUniforms& units, bool maps) const
{
  this->Table.GetValues().Bind(units.WarpUnit);
  if (units.GridLayers > 0)
  {
    this->Table.GetGrid().Bind(units.GridUnit);
  }
  if (maps)
  {
    this->Layers.GetDepths().Bind(units.DepthUnit);
    this->Layers.GetGradients().Bind(units.GradientUnit);
    this->Masking.GetMask().Bind(units.MaskUnit);
  }
  if (maps && !units.Points.empty())
  {
    this->Masking.GetBits().Bind(units.BitsUnit);
    this->Sampler.GetManySamples().Bind(units.ManyUnit);
  }
}

void ShadowPipeline::UnbindTextures(const ReceiverUniforms& units) const
{
  this->Table.GetValues().Unbind(units.WarpUnit);
  if (units.GridLayers > 0)
  {
    this->Table.GetGrid().Unbind(units.GridUnit);
  }
  this->Layers.GetDepths().Unbind(units.DepthUnit);
  this->Layers.GetGradients().Unbind(units.GradientUnit);
  this->Masking.GetMask().Unbind(units.MaskUnit);
  if (!units.Points.empty())
  {
    this->Masking.GetBits().Unbind(units.BitsUnit);
    this->Sampler.GetManySamples().Unbind(units.ManyUnit);
  }
}
}
