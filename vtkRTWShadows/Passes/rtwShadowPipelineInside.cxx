// SPDX-License-Identifier: BSD-3-Clause
// What somebody wants to know of a frame that the picture doesn't need.
#include "Passes/rtwShadowPipeline.h"

#include "GL/rtwStateGuard.h"

#include "vtkOpenGLRenderWindow.h"

#include <limits>

namespace rtw
{
MapOfLight ShadowPipeline::MapOf(int light) const
{
  const int first = light * this->LayerFrames.front().Parts;
  return { this->LayerFrames[first], this->OtherLayers, this->Sampler, this->Table };
}

bool ShadowPipeline::PaintDebugView(DebugView view, int light, const PipelineOptions& options,
  const std::function<void()>& mapperSamples)
{
  this->CompleteViewSamples(mapperSamples);
  if (view == DebugView::Shadow)
  {
    this->GetMask(options, mapperSamples);
  }
  StateGuard guard(this->Window);
  if (view == DebugView::ListLengths)
  {
    return this->PaintLists(light, options);
  }
  if ((view == DebugView::Shadow && !this->HasMask) || !this->Debugging.Build(this->GetShape()))
  {
    return false;
  }
  this->Debugging.Paint(
    view, this->MapOf(light), this->Masking.GetMask(), DepthRounding * this->SceneSize);
  return true;
}

// False where there are none.
bool ShadowPipeline::PaintLists(int light, const PipelineOptions& options)
{
  const ReceiverLights lights =
    ReceiverLights::Make(this->Frames, this->Viewed, options.Lookup, this->SceneSize);
  return this->UsesSource(options) &&
    this->Source->PaintLists(
      this->MakeJob(lights, options), light, DepthRounding * this->SceneSize);
}

bool ShadowPipeline::MeasureAliasing(
  int light, Texture& error, const std::function<void()>& mapperSamples)
{
  this->CompleteViewSamples(mapperSamples);
  StateGuard guard(this->Window);
  return this->Debugging.Build(this->GetShape()) &&
    this->Debugging.Measure(this->MapOf(light), error);
}

double ShadowPipeline::PredictError(
  int light, const PipelineOptions& options, const std::function<void()>& mapperSamples)
{
  const Texture& mask = this->GetMask(options, mapperSamples);
  if (!this->HasMask || this->MaskedBySource)
  {
    return this->HasMask ? 0 : -1;
  }
  StateGuard guard(this->Window);
  const ReceiverLights lights =
    ReceiverLights::Make(this->Frames, this->Viewed, options.Lookup, this->SceneSize);
  return this->Prediction.Predict(
    { this->MapOf(light), mask, lights, this->Layers }, options.Shape);
}

glm::dvec2 ShadowPipeline::ReadInterval(int layer) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (this->LayerFrames[layer].Parts == 1)
  {
    return glm::dvec2(-infinity, infinity);
  }
  // The ends of the first and the last say that all belongs to them.
  const double begin = this->Viewed.Begin;
  const glm::dvec2 interval = this->Table.ReadInterval(layer);
  return { interval.x == 0 ? 0 : interval.x + begin,
    interval.y > 1e38 ? interval.y : interval.y + begin };
}

std::vector<float> ShadowPipeline::ReadImportance(int layer) const
{
  return this->OwnDrawing ? this->Warp->ReadImportance(layer, this->Table) : std::vector<float>();
}
}
