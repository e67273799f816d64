// SPDX-License-Identifier: BSD-3-Clause
// What a frame draws: view samples, the analysis of them, the layers, and the mask.
#include "Passes/rtwShadowPipeline.h"

#include "Frame/rtwFramedView.h"
#include "GL/rtwStateGuard.h"
#include "Importance/rtwAnalysisInput.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
constexpr double DepthStep = 6e-8;    // of 24 bits
constexpr double CoarsestStep = 1e-4; // of what is seen
}

bool ShadowPipeline::NeedsViewSamples(const PipelineOptions& options) const
{
  return this->OwnDrawing &&
    (options.Masked || options.FocusOnView || options.Turn == Turning::Automatic ||
      this->Warp->NeedsViewSamples() || this->Partition->NeedsViewSamples());
}

// True where the last frame shows about what this one will.
bool ShadowPipeline::ResampleLastFrame(const PipelineOptions& options)
{
  if (!options.PreviousFrame || !this->Last.Resembles(this->Viewed, this->SceneSize))
  {
    return false;
  }
  // A depth buffer whose range is wide beside what is seen of it says too little of that.
  const View& last = this->Last.GetView();
  const double step = last.Framed ? DepthStep * std::abs(DepthToSample(last).x) : 0;
  if (step > CoarsestStep)
  {
    return false;
  }
  StageTimers::Scope timer(this->Timers, "resampling");
  return this->Sampler.Resample(
    this->Last, std::min(options.ViewSampleStride, FocusStride));
}

void ShadowPipeline::CaptureFrame(const PipelineOptions& options)
{
  if (options.PreviousFrame && this->OwnDrawing && this->Last.GetSignature() != this->LastSignature)
  {
    StateGuard guard(this->Window);
    this->Last.Capture(this->Viewed, this->LastSignature);
  }
}

// What mappers draw is as unwarped in a light's image as in their own layers.
bool ShadowPipeline::DrawLightImages(
  StateGuard& guard, const PipelineOptions& options, const MapperDrawing& mappers)
{
  const int size = this->OwnDrawing ? this->Warp->GetLightImageSize() : 0;
  if (size == 0 || !this->Images.Build())
  {
    return false;
  }
  StageTimers::Scope timer(this->Timers, "light images");
  this->Images.Start(
    this->ClampResolution(static_cast<unsigned int>(size), this->LayerFrames.size()),
    this->CountLayers(), this->Table);
  for (const LightFrame& frame : this->LayerFrames)
  {
    StateGuard::PrepareDepthDrawing(this->Can.DepthClamp);
    if (!this->Images.Draw(this->Store, frame, frame.Layer, options.Casters.Cull))
    {
      return false;
    }
    if (this->OtherLayers > 0)
    {
      guard.DrawWithVTK([&] { mappers.Casters(frame.Layer + this->OtherLayers, frame); });
    }
  }
  return true;
}

// From what was analysed to a filled warp table.
void ShadowPipeline::RunWarp(
  const FrameScene& scene, const PipelineOptions& options, bool hasImages, const Texture* lastMask)
{
  if (this->OwnDrawing)
  {
    StageTimers::Scope timer(this->Timers, "warp");
    const LookupOptions& lookup = options.Lookup;
    // What is shaded elsewhere than at samples of this frame might lie anywhere.
    this->Warp->Run(this->LayerFrames,
      { this->Sampler, this->Focus.GetBlocks(), this->GetStride(options), this->SceneSize,
        hasImages ? &this->Images.GetImages() : nullptr, lastMask, this->Masked,
        options.Masked && !this->Resampled,
        this->UnsampledReceiversOfAll(scene, lookup.FilterWorld), lookup.FilterWorld,
        lookup.FilterTexels, options.Casters.StraightLength() },
      this->Table);
  }
}

void ShadowPipeline::Draw(const FrameScene& scene, const std::vector<ShadowLight>& lights,
  const PipelineOptions& options, const MapperDrawing& mappers, bool still)
{
  this->Timers.NextFrame();
  StateGuard guard(this->Window);
  if (this->OwnDrawing)
  {
    StageTimers::Scope timer(this->Timers, "geometry");
    this->Store.Update(scene.Parts, this->Viewed);
  }
  this->MakeFrames(scene, lights);
  const int layers = this->CountLayers();
  this->OtherLayers = this->CountOtherLayers(scene, this->LayerFrames.size());
  this->Table.Allocate((this->OwnDrawing ? this->Warp : this->Fallback)->GetCells(),
    options.Resolution, layers + this->OtherLayers, layers,
    this->GetShape().Kind == WarpKind::Grid);
  this->AllocateMaps(scene, options);
  if (this->OwnDrawing)
  {
    this->Casters.Build(this->Warp->GetShape(),
      this->HasUniformTable() ? TableAccess::Uniforms : TableAccess::Storage);
  }
  const Texture& mask = this->Masking.GetMask();
  // One that somebody asked for later must not change what is drawn.
  const bool hasLast = this->HasMask && options.Masked && mask.GetLayers() == int(lights.size());
  const Texture* const lastMask = hasLast ? &mask : nullptr;
  this->HasSamples = this->HasMask = false;
  this->Resampled = this->NeedsViewSamples(options) && this->ResampleLastFrame(options);
  this->Settled = !this->Resampled || this->Last.GetSignature() == this->LastSignature;
  if (!this->Resampled && this->NeedsViewSamples(options))
  {
    this->DrawViewSamples(guard, scene.Props.empty() ? nullptr : mappers.ViewSamples);
  }
  this->DrawMaps(guard, scene, options, mappers, lastMask, still);
  this->AskForTurns(scene, options, this->HasMask ? &mask : nullptr);
  this->AskForSplit(options);
  // Of the first frame there is no better choice to wait for: it is drawn once more.
  if (this->Turns.IsUndecided() && this->Turns.Wait())
  {
    this->MakeFrames(scene, lights);
    this->DrawMaps(guard, scene, options, mappers, lastMask, still);
  }
  if (this->Splits.IsUndecided() && this->Splits.Wait())
  {
    this->AllocateMaps(scene, options);
    this->DrawMaps(guard, scene, options, mappers, lastMask, still);
  }
  this->Counted.ShadowMemory = static_cast<std::int64_t>(this->Layers.GetMemory() +
    this->Table.GetMemory() + this->Sampler.GetMemory() + this->Masking.GetMask().GetMemory() +
    this->Casters.GetMemory() + this->Images.GetMemory() + this->Focus.GetMemory() +
    this->Deepest.GetMemory() +
    (this->Source && this->OwnsShared ? this->Source->GetMemory() : 0));
}

// From view samples to the mask.
void ShadowPipeline::DrawMaps(StateGuard& guard, const FrameScene& scene,
  const PipelineOptions& options, const MapperDrawing& mappers, const Texture* lastMask,
  bool still)
{
  this->BoundSamples(options);
  this->Split(options);
  this->FindFocus(scene, options);
  if (this->OwnDrawing)
  {
    this->Warp->Follow({ this->LayerFrames, this->Viewed, this->SceneSize, options.Signature, still,
                         this->Settled, options.FocusOnView, this->OtherLayers },
      this->Table);
    this->Settled = this->Settled && this->Warp->IsSettled();
  }
  const bool hasImages = this->DrawLightImages(guard, options, mappers);
  this->RunWarp(scene, options, hasImages, lastMask);
  const bool bySource = this->UsesSource(options);
  // Receivers that have no view samples look at maps.
  this->HasMaps = !bySource || !scene.UnsampledReceivers.empty();
  this->DrawLayers(guard, scene, options, mappers, this->HasMaps);
  if (bySource && this->DrawMaskBySource(guard, scene, options, mappers))
  {
    return;
  }
  if (!this->HasMaps)
  {
    this->HasMaps = true;
    this->DrawLayers(guard, scene, options, mappers, true);
  }
  if (options.Masked)
  {
    this->DrawMask(options);
  }
}

void ShadowPipeline::DrawLayers(StateGuard& guard, const FrameScene& scene,
  const PipelineOptions& options, const MapperDrawing& mappers, bool own)
{
  for (int layer = 0; layer < this->CountLayers(); ++layer)
  {
    this->DrawLayer(guard, layer, scene, options, mappers, own);
  }
}

void ShadowPipeline::PrimeDepth(const FrameScene& scene, const PipelineOptions& options)
{
  const bool knowsDepth = this->HasSamples && this->Sampler.GetSamplesAPixel() == 1;
  if (knowsDepth && options.Masked && scene.SamplesAreComplete)
  {
    StateGuard guard(this->Window);
    this->Sampler.PrimeDepth(DepthRounding * this->SceneSize);
  }
}

void ShadowPipeline::DrawViewSamples(StateGuard& guard, const std::function<void()>& mapperSamples)
{
  StageTimers::Scope timer(this->Timers, "view samples");
  this->HasSamples =
    this->Sampler.Render(this->Viewed, this->Store, this->OwnDrawing, this->SamplesAPixel);
  if (mapperSamples && this->Sampler.BindTarget())
  {
    guard.DrawWithVTK(mapperSamples);
  }
  this->Sampler.Finish();
}

void ShadowPipeline::DrawMask(const PipelineOptions& options)
{
  StageTimers::Scope timer(this->Timers, "mask");
  const bool uniforms =
    this->HasUniformTable() && this->OtherLayers == 0 && options.Shape.Parts == 1;
  if (this->HasSamples &&
    this->Masking.Build(options.Shape, uniforms ? TableAccess::Uniforms : TableAccess::Texels,
      this->Can.FastUniforms && options.Shape.Parts > 1))
  {
    this->Masking.Render(
      ReceiverLights::Make(this->Frames, this->Viewed, options.Lookup, this->SceneSize),
      this->OtherLayers, this->Sampler, this->Layers, this->Table);
    this->HasMask = true;
    this->MaskedBySource = false;
    this->Masked = this->Viewed;
  }
}

// For those who look where the frame itself had no need to.
void ShadowPipeline::CompleteViewSamples(const std::function<void()>& mapperSamples)
{
  if (!this->HasSamples)
  {
    StateGuard guard(this->Window);
    this->DrawViewSamples(guard, mapperSamples);
  }
}

const Texture& ShadowPipeline::GetMask(
  const PipelineOptions& options, const std::function<void()>& mapperSamples)
{
  if (!this->HasMask && !this->Frames.empty())
  {
    this->CompleteViewSamples(mapperSamples);
    StateGuard guard(this->Window);
    this->DrawMask(options);
  }
  return this->Masking.GetMask();
}

// Where only view samples are looked up, and where it pays: tiles cost far more than samples do.
const DeepestSamples* ShadowPipeline::FindDeepest(
  const LightFrame& frame, const FrameScene& scene, const PipelineOptions& options)
{
  const bool areAll = this->HasSamples && !this->Resampled && options.Masked &&
    scene.UnsampledReceivers.empty() && options.Lookup.FilterWorld == 0;
  const bool pays = this->GetShape().Kind == WarpKind::Grid && frame.Parts == 1;
  if (!areAll || !pays || !options.Casters.Cull || !this->Deepest.Build(this->GetShape()))
  {
    return nullptr;
  }
  this->Deepest.Find(frame, this->Sampler, this->Table, options.Lookup.FilterTexels + 1);
  return &this->Deepest;
}

void ShadowPipeline::DrawLayer(StateGuard& guard, int layer, const FrameScene& scene,
  const PipelineOptions& options, const MapperDrawing& mappers, bool own)
{
  const LightFrame& frame = this->LayerFrames[layer];
  StageTimers::Scope timer(this->Timers, "light pass");
  StateGuard::PrepareDepthDrawing(this->Can.DepthClamp);
  if (own && !this->Layers.BindTarget(layer))
  {
    return;
  }
  if (own && this->OwnDrawing)
  {
    this->Casters.StartLayer(layer);
    this->Casters.Draw(this->Store, this->Table, frame, layer, options.Casters,
      this->FindDeepest(frame, scene, options));
  }
  const int others = layer + this->OtherLayers;
  if (std::any_of(
        scene.Props.begin(), scene.Props.end(), [](const SceneProp& prop) { return prop.Casts; }) &&
    (others == layer || this->Layers.BindTarget(others)))
  {
    guard.DrawWithVTK([&] { mappers.Casters(others, frame); });
  }
}
}
