// SPDX-License-Identifier: BSD-3-Clause
#include "Partition/rtwDepthSplitStage.h"

#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwView.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwOrdered.h"
#include "Layers/rtwSampleBlocks.h"
#include "Layers/rtwSampleOfLayer.h"
#include "Layers/rtwVisitSamples.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwBackwardSample.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Partition/rtwDepthBins.h"
#include "Partition/rtwDepthSplits.h"
#include "Partition/rtwSeenRange.h"
#include "Partition/rtwSplitByBins.h"
#include "Partition/rtwWriteIntervals.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace rtw
{
namespace
{
constexpr double Nowhere = 3e38; // NOWHERE of rtwWriteIntervals.glsl
// One in so many samples, along both axes, is put into a bin: bins are an estimate.
constexpr int BinningStride = 2;
constexpr int NumberOfBins = 128;
constexpr int BinSize = 6;   // numbers of each bin in shared memory
constexpr int BinStride = 8; // numbers of each bin in the buffer

// The uniform rtwBeyondEye of rtwSeenRange.glsl.
float BeyondEye(const View& view)
{
  return view.Parallel ? -1.f : float(view.BeyondEye());
}

std::string BinDefinitions()
{
  return "#define BINS " + std::to_string(NumberOfBins) + "\n#define BIN_SIZE " +
    std::to_string(BinSize) + "\n#define BIN_STRIDE " + std::to_string(BinStride) + "\n";
}
}

DepthSplitStage::DepthSplitStage(std::function<DepthSplitSettings()> settings)
  : Settings(std::move(settings))
{
}

bool DepthSplitStage::Build()
{
  const std::string bins = BinDefinitions();
  return this->Binning.Build({ { GL_COMPUTE_SHADER,
           { bins.c_str(), rtwOrdered, rtwWarpFocus, rtwLayerInterval, rtwViewSampleAccess,
             rtwSamplePlace, rtwLitSample, rtwSampleOfLayer, rtwBackwardSample, rtwSampleBlocks,
             rtwVisitSamples, rtwSeenRange, rtwDepthBins } } }) &&
    this->Splitting.Build(
      { { GL_COMPUTE_SHADER, { bins.c_str(), rtwOrdered, rtwSeenRange, rtwSplitByBins } } }) &&
    this->Writing.Build({ { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwSeenRange, rtwWriteIntervals } } });
}

std::string DepthSplitStage::GetLog() const
{
  return this->Binning.GetLog() + this->Splitting.GetLog() + this->Writing.GetLog();
}

bool DepthSplitStage::IsFixed(const PartitionInput& input) const
{
  return this->Settings().Steady || !input.FocusOnView;
}

std::vector<double> DepthSplitStage::FixedBorders(const PartitionInput& input) const
{
  const DepthSplitSettings settings = this->Settings();
  // A parallel view has no eye from which depths could have ratios.
  return SplitDepths(this->Steady.at(input.Viewer), input.Parts / input.Faces,
    input.Viewed.Parallel ? 0 : settings.Lambda);
}

void DepthSplitStage::WriteFixed(const PartitionInput& input, LayerTable& table) const
{
  const std::vector<double> borders = this->FixedBorders(input);
  const double blend = this->Settings().Blend;
  for (std::size_t layer = 0; layer < input.Frames.size() * input.Parts; ++layer)
  {
    const std::size_t k = layer % input.Parts / input.Faces;
    const bool isLast = k + 2 == borders.size();
    const double from = k == 0 ? 0 : borders[k];
    // Depths are measured from where view coordinates begin.
    const double beyond = input.Viewed.BeyondEye();
    table.WriteInterval(static_cast<int>(layer),
      { k == 0 ? 0 : from - beyond, isLast ? Nowhere : borders[k + 1] - beyond },
      k == 0 ? 0 : from - blend * (from - borders[k - 1]) - beyond);
  }
}

std::optional<Rectangle> DepthSplitStage::FocusOf(
  const LightFrame& frame, const PartitionInput& input) const
{
  if (!this->IsFixed(input) || frame.Parts == 1)
  {
    return {};
  }
  const std::vector<double> borders = this->FixedBorders(input);
  const int part = frame.Layer % frame.Parts / frame.Faces;
  glm::dvec2 depths(borders[part], borders[part + 1]);
  depths.x -= part == 0 ? 0 : this->Settings().Blend * (depths.x - borders[part - 1]);
  return SteadyFocus(frame, input.Viewed, depths, input.Reach, input.Resolution);
}

void DepthSplitStage::SplitBySamples(const PartitionInput& input, const LayerTable& table)
{
  const std::vector<std::uint32_t> empty{ 0xffffffffu, 0xffffffffu, 0, 0, 0, 0, 0, 0 };
  std::vector<std::uint32_t> start;
  for (std::size_t bin = 0; bin < NumberOfBins * input.Frames.size(); ++bin)
  {
    start.insert(start.end(), empty.begin(), empty.end());
  }
  this->Bins.Assign(start);
  this->Splits.Reserve(input.Frames.size() * MostLayers * sizeof(float));
  const int stride = BinningStride * input.Stride;
  this->Binning.Use();
  this->Binning.Set("rtwBeyondEye", BeyondEye(input.Viewed));
  input.Samples.Bind(this->Binning);
  table.Bind(this->Binning);
  input.Range.BindStorage(0);
  this->Bins.BindStorage(1);
  for (std::size_t light = 0; light < input.Frames.size(); ++light)
  {
    const Rectangle& b = input.Frames[light].Bounds;
    BindLight(this->Binning, input.Frames[light], input.Samples.GetView(), stride);
    this->Binning.Set("rtwLight", static_cast<int>(light));
    glUniform4f(this->Binning.Location("rtwWholeBounds"), float(b.Low.x), float(b.Low.y),
      float(b.High.x), float(b.High.y));
    input.Blocks.Dispatch(this->Binning, input.Samples, stride, -1);
  }
  this->Splitting.Use();
  this->Splitting.Set("rtwBeyondEye", BeyondEye(input.Viewed));
  this->Splits.BindStorage(2);
  this->Splitting.Set("rtwParts", input.Parts / input.Faces);
  Dispatch(static_cast<int>(input.Frames.size()));
}

void DepthSplitStage::Split(const PartitionInput& input, LayerTable& table)
{
  if (this->IsFixed(input))
  {
    glm::dvec2& range = this->Steady[input.Viewer];
    range = SteadyRange(input.Viewed, range);
    this->WriteFixed(input, table);
    return;
  }
  const DepthSplitSettings settings = this->Settings();
  const bool bySamples = settings.BySamples && input.Parts > input.Faces;
  if (bySamples)
  {
    this->SplitBySamples(input, table);
  }
  this->Writing.Use();
  this->Writing.Set("rtwBeyondEye", BeyondEye(input.Viewed));
  table.Bind(this->Writing);
  input.Range.BindStorage(0);
  table.GetValues().BindStorage(1);
  this->Splits.Reserve(sizeof(float));
  this->Splits.BindStorage(2);
  this->Writing.Set("rtwParts", input.Parts / input.Faces);
  this->Writing.Set("rtwFaces", input.Faces);
  this->Writing.Set("rtwSplitBySamples", bySamples ? 1 : 0);
  this->Writing.Set("rtwLambda", static_cast<float>(settings.Lambda));
  this->Writing.Set("rtwBlend", static_cast<float>(settings.Blend));
  Dispatch(static_cast<int>(input.Frames.size()));
}

void DepthSplitStage::Dispose(Disposal dispose)
{
  dispose(this->Binning, this->Splitting, this->Writing, this->Bins, this->Splits);
  this->Steady.clear();
}
}
