// SPDX-License-Identifier: BSD-3-Clause
// What a frame has for the shaders of receivers.
#include "Passes/rtwShadowPipeline.h"

#include "Frame/rtwFramedView.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
ReceiverUniforms ShadowPipeline::MakeUniforms(const PipelineOptions& options) const
{
  ReceiverUniforms uniforms;
  uniforms.Cells = this->Table.GetCells();
  uniforms.Resolution = this->Table.GetResolution();
  uniforms.MapSize = this->Table.GetMapSize();
  uniforms.WarpedLayers = this->Table.GetWarpedLayers();
  uniforms.GridLayers = this->Table.GetGridLayers();
  uniforms.OtherLayers = this->OtherLayers;
  this->PlaceReceivers(uniforms);
  if (options.SamplesAPixel > 1)
  {
    uniforms.Points = this->Sampler.GetOffsets();
    uniforms.HiddenBeyond = float(DepthRounding * this->SceneSize);
  }
  uniforms.Lights =
    ReceiverLights::Make(this->Frames, this->Viewed, options.Lookup, this->SceneSize);
  return uniforms;
}

void ShadowPipeline::PlaceReceivers(ReceiverUniforms& uniforms) const
{
  const View& view = this->Viewed;
  const glm::dvec2 toSample = DepthToSample(view);
  uniforms.Framed = view.Framed || view.Parallel;
  uniforms.ViewBegin = float(view.Begin);
  uniforms.Ray = glm::vec4(RayOf(view));
  uniforms.OfSample = glm::vec4(PlaceOf(view));
  const glm::dvec2 scale(2.0 / view.Width, 2.0 / view.Height);
  uniforms.ToClip = glm::vec4(scale, -scale * glm::dvec2(view.OriginX, view.OriginY) - 1.0);
  uniforms.RayStep = glm::vec3(RayStep(view));
  const glm::vec2 beside(SeenFrom(view));
  uniforms.SeenFrom = glm::vec3(beside, view.Parallel ? 1.f : 0.f); // beside the camera
  uniforms.DepthToSample = glm::vec2(toSample);
  uniforms.OwnDepthToSample = glm::vec2(OwnDepthToSample(view));
  // Of what is finer: a step of depth in units of length, or one of the distance from the camera.
  const double stepOfDepth = std::abs(toSample.x) * (view.Range.y - view.Range.x);
  const double farthest = std::max(std::abs(view.Range.x), std::abs(view.Range.y));
  uniforms.PlacedBy = !view.Framed ? 0 : stepOfDepth > farthest ? 1 : 2;
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
}
