// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/rtwShadowPipeline.h"

#include "Warp/Identity/rtwIdentityWarpStage.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtw
{
ShadowPipeline::ShadowPipeline()
  : Warp(std::make_unique<IdentityWarpStage>())
  , Fallback(std::make_unique<IdentityWarpStage>())
  , Partition(std::make_unique<WholeViewStage>())
  , SharedStore(std::make_shared<GeometryStore>())
  , Store(*this->SharedStore)
{
}

ShadowPipeline::ShadowPipeline(const ShadowPipeline* main)
  : Warp(std::make_unique<IdentityWarpStage>())
  , Fallback(std::make_unique<IdentityWarpStage>())
  , Partition(std::make_unique<WholeViewStage>())
  , Source(main->Source)
  , SharedStore(main->SharedStore)
  , Store(*this->SharedStore)
  , OwnsShared(false)
{
  this->Timers.SetEnabled(main->Timers.GetEnabled());
}

ShadowPipeline::~ShadowPipeline() = default;

void ShadowPipeline::SetWarp(std::unique_ptr<WarpStage> warp)
{
  this->Retired.push_back(std::exchange(this->Warp, std::move(warp)));
  this->LastSignature = 0;
  this->Stale = true;
}

void ShadowPipeline::SetMaskSource(std::unique_ptr<MaskSource> source)
{
  if (this->Source && this->OwnsShared)
  {
    this->Retired.push_back(this->Source);
  }
  this->Source = std::move(source);
  this->LastSignature = 0;
}

bool ShadowPipeline::TakeIncomplete()
{
  return std::exchange(this->Incomplete, false);
}

CasterCounts ShadowPipeline::ReadCasterCounts(int layer) const
{
  return this->Source && !this->HasMaps ? this->Source->ReadCounts(layer)
                                        : this->Casters.ReadCounts(layer);
}

void ShadowPipeline::SetPartition(std::unique_ptr<PartitionStage> partition)
{
  this->Retired.push_back(std::exchange(this->Partition, std::move(partition)));
  this->LastSignature = 0;
  this->Stale = true;
}

int ShadowPipeline::CountParts(std::size_t lights) const
{
  // There may be as many layers again, of casters that mappers draw.
  const int most =
    this->Can.MaximumLayers / (2 * static_cast<int>(std::max<std::size_t>(lights, 1)));
  if (!this->OwnDrawing || this->Source) // which has one grid a light
  {
    return 1;
  }
  const int faces = this->Partition->GetNumberOfFaces();
  const int depths = this->Partition->GetNumberOfLayers() / faces;
  return faces * std::clamp(depths, 1, std::max(most / faces, 1));
}

int ShadowPipeline::CountFaces(int parts) const
{
  return parts > 1 ? this->Partition->GetNumberOfFaces() : 1;
}

WarpShape ShadowPipeline::GetShape() const
{
  return (this->OwnDrawing ? this->Warp : this->Fallback)->GetShape();
}

bool ShadowPipeline::IsOf(vtkOpenGLRenderWindow* window) const
{
  return this->Window == window && this->ContextTime == window->GetContextCreationTime();
}

bool ShadowPipeline::SetContext(vtkOpenGLRenderWindow* window)
{
  if (!window)
  {
    return false;
  }
  const bool same = this->IsOf(window);
  if (!same)
  {
    this->Dispose(Disposal::Abandon());
  }
  this->DisposeOfRetired(Disposal::Release());
  if (same && !this->Stale)
  {
    return true;
  }
  this->Stale = false;
  this->Window = window;
  this->ContextTime = window->GetContextCreationTime();
  this->LastSignature = 0;
  this->Can = Capabilities::Query();
  this->OwnDrawing = this->Build();
  return true;
}

bool ShadowPipeline::Build()
{
  if (!this->Can.Compute)
  {
    this->Problem = "OpenGL " + std::to_string(this->Can.Major) + "." +
      std::to_string(this->Can.Minor) + " has no compute shaders (4.3 has)";
    return false;
  }
  if (this->Warp->GetShape().Kind == WarpKind::Grid &&
    this->Can.MaximumTexels < CasterDrawing::TexelsOfTiles)
  {
    this->Problem = "a buffer texture holds no more than " +
      std::to_string(this->Can.MaximumTexels) +
      " texels, of which a warp that isn't separable needs " +
      std::to_string(CasterDrawing::TexelsOfTiles);
    return false;
  }
  const bool built = this->Store.Build() && this->Sampler.Build() && this->Focus.Build() && this->Warp->Build() &&
    this->Partition->Build() &&
    this->Casters.Build(this->Warp->GetShape(),
      this->Can.FastUniforms ? TableAccess::Uniforms : TableAccess::Storage);
  this->Problem = built
    ? std::string()
    : "the driver refused a shader: " + this->Store.GetLog() + this->Sampler.GetLog() + this->Focus.GetLog() +
      this->Warp->GetLog() + this->Partition->GetLog() + this->Casters.GetLog();
  return built;
}

int ShadowPipeline::CountOtherLayers(const FrameScene& scene, std::size_t layers) const
{
  const bool others = std::any_of(
    scene.Props.begin(), scene.Props.end(), [](const SceneProp& prop) { return prop.Casts; });
  const bool apart = this->OwnDrawing && (this->Warp->DrawsMappersApart() || this->Source);
  return others && apart ? static_cast<int>(layers) : 0;
}

// Of all that the layers depend on; never 0.
std::uint64_t ShadowPipeline::Sign(const FrameScene& scene, const std::vector<ShadowLight>& lights,
  const PipelineOptions& options) const
{
  std::uint64_t signature = Mix(scene.Signature, options.Signature);
  signature = Mix(signature, this->Source ? this->Source->GetSignature() : std::uint64_t(0));
  for (const ShadowLight& light : lights)
  {
    signature = Mix(signature, std::uint64_t(light.Kind));
    for (int k = 0; k < 3; ++k)
    {
      signature = Mix(Mix(signature, light.Position[k]), light.Direction[k]);
    }
    signature = Mix(signature, light.ConeAngle);
  }
  signature = Mix(signature, std::uint64_t(this->Viewed.Width));
  signature = Mix(signature, std::uint64_t(this->Viewed.Height));
  signature = Mix(Mix(signature, this->Viewed.DepthRow.x), this->Viewed.DepthRow.y);
  return Mix(Mix(signature, this->Viewed.WorldToView), this->Viewed.ViewToClip) | 1;
}

bool ShadowPipeline::Update(const View& view, const FrameScene& scene,
  const std::vector<ShadowLight>& lights, const PipelineOptions& options,
  const MapperDrawing& mappers)
{
  this->Viewed = FrameView(view, scene);
  this->SamplesAPixel = options.SamplesAPixel;
  this->Counted.Lights = static_cast<int>(lights.size());
  this->Counted.LayersDrawn = this->Counted.LayersReused = 0;
  if (!view.IsUsable() || lights.empty() || scene.IsEmpty() || !scene.HasBounds)
  {
    this->Frames.clear();
    this->LayerFrames.clear();
    this->LastSignature = 0;
    return false;
  }
  const Turning turn = this->TurningOf(options);
  this->Turns.Begin(
    turn, options.Viewer, lights, view, this->FindMinimalFrusta(scene, lights, turn));
  this->Splits.Begin(
    this->OwnDrawing && this->Warp->SplitsByError(), options.Viewer, options.Signature);
  // Which changes the signature.
  this->Incomplete = (this->Source && this->Source->WasIncomplete()) || this->Incomplete;
  const std::uint64_t signature = this->Sign(scene, lights, options);
  if (options.Caching && signature == this->LastSignature && this->Settled &&
    this->Turns.GetTurns() == this->DrawnTurns && !this->Turns.IsUndecided() &&
    this->Splits.GetRatio() == this->DrawnRatio)
  {
    // What no map depends on may have changed all the same.
    for (std::size_t i = 0; i < this->Frames.size(); ++i)
    {
      this->Frames[i].Light = lights[i];
    }
    for (LightFrame& frame : this->LayerFrames)
    {
      frame.Light = lights[frame.Number()];
    }
    this->Counted.LayersReused = this->CountLayers();
    return true;
  }
  const bool still = signature == this->LastSignature;
  this->LastSignature = signature;
  this->Draw(scene, lights, options, mappers, still);
  this->Counted.LayersDrawn = this->CountLayers();
  return true;
}

int ShadowPipeline::ClampResolution(unsigned int resolution, std::size_t layers) const
{
  // Each layer, and that of its other casters.
  const int rows =
    LayerTable::RowsPerLayer * 2 * static_cast<int>(std::max<std::size_t>(layers, 1));
  int most = std::min(this->Can.MaximumTextureSize, this->Can.MaximumTexels / rows);
  if (this->GetShape().Kind == WarpKind::Grid)
  {
    // Each layer's grid has an element a texel, and two a cell.
    const double cells = 2.0 * this->Warp->GetCells() * this->Warp->GetCells();
    const double each = this->Can.MaximumTexels / double(std::max<std::size_t>(layers, 1));
    most = std::min(most, static_cast<int>(std::sqrt(std::max(each - cells, 1.0))));
  }
  return static_cast<int>(std::min<unsigned int>(resolution, static_cast<unsigned int>(most)));
}

glm::dvec2 ShadowPipeline::ReadMaximumEffectiveResolution(int layer) const
{
  if (layer < 0 || layer >= this->CountLayers())
  {
    return glm::dvec2(0);
  }
  const Rectangle focus = this->Table.ReadFocus(layer);
  const Rectangle& whole = this->LayerFrames[layer].Bounds;
  const glm::dvec2 share = (whole.High - whole.Low) / (focus.High - focus.Low);
  const WarpStage& warp = this->OwnDrawing ? *this->Warp : *this->Fallback;
  return share * warp.ReadGreatestDensity(layer) * glm::dvec2(this->Table.GetMapSize());
}

void ShadowPipeline::DisposeOfRetired(Disposal dispose)
{
  for (const auto& stage : this->Retired)
  {
    dispose(*stage);
  }
  this->Retired.clear();
}

void ShadowPipeline::Dispose(Disposal dispose)
{
  this->DisposeOfRetired(dispose);
  if (this->Source && this->OwnsShared)
  {
    dispose(*this->Source);
  }
  if (this->OwnsShared)
  {
    dispose(this->Store);
  }
  dispose(*this->Warp, *this->Partition, this->Last, this->Turns, this->Splits, this->Sampler,
    this->Focus, this->Casters, this->Deepest, this->Images, this->Masking, this->Debugging,
    this->Prediction, this->Layers, this->Table, this->Timers);
  this->Frames.clear();
  this->LayerFrames.clear();
  this->LastSignature = 0;
  this->HasSamples = this->HasMask = false;
}

void ShadowPipeline::Release(vtkOpenGLRenderWindow* window)
{
  if (!this->Window || this->Window != window)
  {
    return;
  }
  window->MakeCurrent();
  this->Dispose(Disposal::Release());
  this->Window = nullptr;
  this->ContextTime = 0;
}
}
