// SPDX-License-Identifier: BSD-3-Clause
// Where on the light plane each layer's map lies: its depths, its focus, and the turn to ask for.
#include "Passes/rtwShadowPipeline.h"

#include "Warp/Perspective/rtwResolutionSplit.h"

#include <algorithm>
#include <limits>

namespace rtw
{
namespace
{
constexpr double ResampledMargin = 0.05; // of the focus, for what the last frame has not seen
}

Rectangle ShadowPipeline::UnsampledReceivers(
  const FrameScene& scene, const LightFrame& frame, double beyond)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Rectangle bounds{ glm::dvec2(infinity), glm::dvec2(-infinity) };
  for (const glm::dvec3& corner : scene.UnsampledReceivers)
  {
    const glm::dvec2 l = frame.Project(corner);
    // Behind a spot: no light falls there, but the box may reach anywhere.
    bounds.Low = glm::min(bounds.Low, l.x < infinity ? l : frame.Bounds.Low);
    bounds.High = glm::max(bounds.High, l.x < infinity ? l : frame.Bounds.High);
  }
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  const double margin = isSpot ? beyond / frame.NearestDistance : beyond;
  return { glm::max(bounds.Low - margin, frame.Bounds.Low),
    glm::min(bounds.High + margin, frame.Bounds.High) };
}

std::vector<Rectangle> ShadowPipeline::UnsampledReceiversOfAll(
  const FrameScene& scene, double beyond) const
{
  std::vector<Rectangle> bounds;
  for (const LightFrame& frame : this->LayerFrames)
  {
    bounds.push_back(UnsampledReceivers(scene, frame, beyond));
  }
  return bounds;
}

// All that can be seen, as far as that is known without view samples.
Rectangle ShadowPipeline::WithoutSamples(std::size_t light, const FilterReach& reach) const
{
  const LightFrame& frame = this->Frames[light];
  if (!this->Minimal[light])
  {
    return frame.Bounds;
  }
  const Rectangle& seen = *this->Minimal[light];
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  const glm::dvec2 margin = (isSpot ? reach.World / frame.NearestDistance : reach.World) +
    reach.Share * (seen.High - seen.Low);
  const Rectangle focus{ glm::max(seen.Low - margin, frame.Bounds.Low),
    glm::min(seen.High + margin, frame.Bounds.High) };
  const bool isAny = focus.Low.x < focus.High.x && focus.Low.y < focus.High.y;
  return isAny ? focus : frame.Bounds;
}

bool ShadowPipeline::CanSplit(const PipelineOptions& options) const
{
  return this->OwnDrawing && !this->Source &&
    !this->Partition->IsFixed(this->MakePartitionInput(options));
}

glm::ivec2 ShadowPipeline::ChooseMapSize(
  const FrameScene& scene, const PipelineOptions& options) const
{
  double ratio = 1;
  if (this->CanSplit(options))
  {
    ratio = this->Warp->SplitsByError()
      ? this->Splits.GetRatio()
      : this->Warp->ChooseTexelRatio({ this->LayerFrames, this->Viewed, scene.Low, scene.High,
          options.Viewer, options.FocusOnView });
  }
  return SplitTexels(options.Resolution, ratio, this->Can.MaximumTextureSize);
}

void ShadowPipeline::AllocateMaps(const FrameScene& scene, const PipelineOptions& options)
{
  this->DrawnRatio = this->Splits.GetRatio();
  this->Table.SetMapSize(this->ChooseMapSize(scene, options));
  this->Layers.Allocate(this->Table.GetMapSize(), this->CountLayers() + this->OtherLayers);
}

FilterReach ShadowPipeline::GetReach(const PipelineOptions& options) const
{
  const glm::ivec2& size = this->Table.GetMapSize();
  return { options.Lookup.FilterWorld,
    options.Lookup.FilterTexels / double(std::min(size.x, size.y)) +
      (this->Resampled ? ResampledMargin : 0) };
}

PartitionInput ShadowPipeline::MakePartitionInput(const PipelineOptions& options) const
{
  return { this->Frames, this->Viewed, options.Viewer, this->Sampler, this->Focus.GetBlocks(),
    this->Focus.GetRange(), this->GetFocusStride(options), this->LayerFrames.front().Parts,
    this->LayerFrames.front().Faces, options.Resolution, options.FocusOnView,
    this->GetReach(options) };
}

BoundedSamples ShadowPipeline::GetBounded(const PipelineOptions& options) const
{
  return { this->Sampler, this->GetFocusStride(options),
    static_cast<float>(options.Lookup.FilterWorld), this->Table };
}

// Where layers go by view samples.
void ShadowPipeline::BoundSamples(const PipelineOptions& options)
{
  this->Focus.ForgetBlocks();
  const int parts = this->LayerFrames.front().Parts;
  if (options.FocusOnView && this->OwnDrawing &&
    (parts == 1 || this->Partition->NeedsViewSamples()))
  {
    StageTimers::Scope timer(this->Timers, "focus");
    this->Focus.Bound(this->Frames, this->GetBounded(options), parts);
  }
}

// What each layer is for, into the warp table.
void ShadowPipeline::Split(const PipelineOptions& options)
{
  if (this->LayerFrames.front().Parts > 1)
  {
    StageTimers::Scope timer(this->Timers, "partition");
    this->Partition->Split(this->MakePartitionInput(options), this->Table);
  }
}

// Into the warp table.
void ShadowPipeline::FindFocus(const FrameScene& scene, const PipelineOptions& options)
{
  const FilterReach reach = this->GetReach(options);
  const PartitionInput input = this->MakePartitionInput(options);
  const std::vector<Rectangle> unsampled = this->UnsampledReceiversOfAll(scene, reach.World);
  if (this->Partition->FocusOf(this->LayerFrames.front(), input))
  {
    for (const LightFrame& frame : this->LayerFrames)
    {
      this->Table.WriteFocus(frame.Layer, *this->Partition->FocusOf(frame, input));
    }
  }
  else if (options.FocusOnView && this->OwnDrawing)
  {
    StageTimers::Scope timer(this->Timers, "focus");
    this->Focus.Reduce(
      this->LayerFrames, unsampled, scene.UnsampledReceivers, this->GetBounded(options), reach);
  }
  else
  {
    for (const LightFrame& frame : this->LayerFrames)
    {
      this->Table.WriteFocus(frame.Layer, this->WithoutSamples(frame.Number(), reach));
    }
  }
  this->Table.ShareFocus(this->OtherLayers);
  for (int layer = 0; layer < this->OtherLayers; ++layer)
  {
    this->Table.WriteIdentity(this->CountLayers() + layer);
  }
}

// Likewise for a frame to come; without a mask there is nothing to tell edges by.
void ShadowPipeline::AskForSplit(const PipelineOptions& options)
{
  if (!this->HasMask || !this->CanSplit(options) ||
    !this->Splits.IsToAsk(this->LastSignature, this->GetShape()))
  {
    return;
  }
  StageTimers::Scope timer(this->Timers, "resolution split");
  std::vector<MapOfLight> lights;
  for (std::size_t light = 0; light < this->Frames.size(); ++light)
  {
    lights.push_back(this->MapOf(static_cast<int>(light)));
  }
  this->Splits.Ask(lights,
    { this->Sampler, this->GetStride(options), &this->Masking.GetMask(), options.Resolution },
    this->LastSignature);
}

// For a frame to come.
void ShadowPipeline::AskForTurns(
  const FrameScene& scene, const PipelineOptions& options, const Texture* mask)
{
  if (!this->Turns.IsToAsk(this->LastSignature))
  {
    return;
  }
  StageTimers::Scope timer(this->Timers, "light plane turn");
  std::vector<TurnedLight> lights;
  for (std::size_t i = 0; i < this->Frames.size(); ++i)
  {
    const LightFrame& frame = this->Frames[i];
    const bool isWhole = !options.FocusOnView && frame.Light.Kind == LightKind::Directional;
    TurnedLight light{ frame, {}, {}, {} };
    for (const double turn : this->Turns.GetCandidates(i))
    {
      light.By.push_back(turn - this->DrawnTurns[i]);
      const LightFrame turned =
        isWhole ? this->MakeFrame(scene, frame.Light, turn) : Turned(frame, light.By.back());
      light.Bounds.push_back(turned.Bounds);
      light.Kept.push_back(options.FocusOnView
          ? UnsampledReceivers(scene, turned, options.Lookup.FilterWorld)
          : turned.Bounds);
    }
    lights.push_back(light);
  }
  this->Turns.Ask(lights,
    { this->Sampler, this->GetStride(options), mask, options.Resolution,
      this->Warp->NeedsViewSamples(), this->Turns.IsByArea() },
    this->LastSignature);
}
}
