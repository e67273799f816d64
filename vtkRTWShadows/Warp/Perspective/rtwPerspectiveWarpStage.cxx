// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Perspective/rtwPerspectiveWarpStage.h"

#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Importance/rtwAnalysisInput.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwSampleBlocks.h"
#include "Layers/rtwSampleOfLayer.h"
#include "Layers/rtwVisitSamples.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwBackwardSample.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Warp/Perspective/rtwBendPerspective.h"
#include "Warp/Perspective/rtwBuildPerspective.h"
#include "Warp/Perspective/rtwNearestSample.h"
#include "Warp/Perspective/rtwPlacedOnWarp.h"
#include "Warp/Perspective/rtwSlopePerspective.h"
#include "Warp/Perspective/rtwWarpPerspective.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace rtw
{
namespace
{
constexpr int LeastStride = 2;        // bounds look at each pixel that might lie beyond them
constexpr double UnseenMargin = 0.05; // a share of the map, for what the last frame has not seen

glm::vec4 ToVector(const Rectangle& r)
{
  return glm::vec4(r.Low, r.High);
}

void Set(const Program& program, const char* uniform, const glm::vec4& v)
{
  glUniform4f(program.Location(uniform), v.x, v.y, v.z, v.w);
}
}

PerspectiveWarpStage::PerspectiveWarpStage(
  std::function<PerspectiveChoice()> choice, std::function<SplitSettings()> split)
  : Choice(std::move(choice))
  , Split(std::move(split))
{
}

double PerspectiveWarpStage::ChooseTexelRatio(const SplitScene& scene)
{
  const SplitSettings split = this->Split();
  return split.Kind == SplitSettings::Critical
    ? this->Ratio.Choose(scene.Viewer, CriticalRatio(this->Choice(), scene))
    : split.Ratio;
}

WarpShape PerspectiveWarpStage::GetShape() const
{
  return { "perspective", rtwWarpPerspective, rtwBendPerspective, rtwSlopePerspective,
    WarpKind::Projective };
}

bool PerspectiveWarpStage::Build()
{
  return this->Looking.Build({ { GL_COMPUTE_SHADER,
           { rtwWarpFocus, rtwLayerInterval, rtwViewSampleAccess, rtwSamplePlace, rtwLitSample,
             rtwSampleOfLayer, rtwBackwardSample, rtwSampleBlocks, rtwVisitSamples,
             rtwNearestSample } } }) &&
    this->Bounding.Build(std::string(rtwWarpPerspective) + rtwBendPerspective + rtwPlacedOnWarp) &&
    this->Building.Build({ { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwBuildPerspective } } });
}

std::string PerspectiveWarpStage::GetLog() const
{
  return this->Looking.GetLog() + this->Bounding.GetLog() + this->Building.GetLog();
}

void PerspectiveWarpStage::Follow(const WarpFrame& frame, const LayerTable&)
{
  this->Viewed = frame.Viewed;
  this->Focused = frame.Focused;
  this->Current = frame.Current;
}

void PerspectiveWarpStage::Run(
  const std::vector<LightFrame>& frames, const AnalysisInput& input, const LayerTable& table)
{
  this->Layers = static_cast<int>(frames.size());
  this->Report.Reserve(frames.size() * sizeof(glm::vec4));
  this->Nearest.Reserve(frames.size() * sizeof(float));
  this->Nearest.Clear();
  std::vector<std::uint32_t> none;
  for (std::size_t i = 0; i < 2 * frames.size(); ++i)
  {
    none.insert(none.end(), { 0xffffffffu, 0xffffffffu, 0u, 0u });
  }
  this->Bounds.Assign(none);
  for (int layer = 0; layer < this->Layers; ++layer)
  {
    this->FindNearest(frames[layer], layer, input, table);
    this->Write(frames[layer], layer, 0, input, table);
    this->FindBounds(frames[layer], input, table);
    this->Write(frames[layer], layer, 1, input, table);
  }
}

void PerspectiveWarpStage::FindNearest(
  const LightFrame& frame, int layer, const AnalysisInput& input, const LayerTable& table)
{
  this->Looking.Use();
  this->Nearest.BindStorage(0);
  input.Samples.Bind(this->Looking);
  table.Bind(this->Looking);
  BindLight(this->Looking, frame, input.Samples.GetView(), input.Stride);
  this->Looking.Set("rtwLayer", layer);
  input.Blocks.Dispatch(this->Looking, input.Samples, input.Stride, layer);
}

// Finds the bounds of the samples on a map whose ends along s are 0 and 1.
void PerspectiveWarpStage::FindBounds(
  const LightFrame& frame, const AnalysisInput& input, const LayerTable& table)
{
  const Rectangle whole{ glm::dvec2(-1e30), glm::dvec2(1e30) };
  const BoundedSamples bounded{ input.Samples, std::min(input.Stride, LeastStride),
    static_cast<float>(input.FilterWorld), table };
  this->Bounding.Start(bounded, 1, 1);
  this->Bounding.Bound(bounded, frame, 0, whole);
  this->Bounding.Unite(bounded, frame, 0, 1, whole, this->Bounds, nullptr);
}

void PerspectiveWarpStage::Write(
  const LightFrame& frame, int layer, int pass, const AnalysisInput& input, const LayerTable& table)
{
  const PerspectiveChoice choice = this->Choice();
  // A map of the whole scene lies around the viewer: it shows no perspective either.
  const ViewOnLight view = LookAtView(
    frame, this->Viewed.Eye, this->Viewed.Forward, this->Viewed.Parallel || !this->Focused);
  this->Building.Use();
  table.Bind(this->Building);
  this->Bounds.BindStorage(0);
  this->Nearest.BindStorage(1);
  table.GetValues().BindStorage(2);
  this->Report.BindStorage(3);
  this->Building.Set("rtwLayer", layer);
  this->Building.Set("rtwPass", pass);
  this->Building.Set("rtwChoice", choice.Kind);
  this->Building.Set("rtwValue", static_cast<float>(choice.Value));
  this->Building.Set("rtwView", static_cast<float>(view.Sine), static_cast<float>(view.Unit),
    static_cast<float>(view.EyeS));
  Set(this->Building, "rtwAlso", ToVector(this->Focused ? input.Unsampled[layer] : frame.Bounds));
  const glm::dvec2 margin =
    input.FilterTexels / glm::dvec2(table.GetMapSize()) + (this->Current ? 0 : UnseenMargin);
  glUniform2f(this->Building.Location("rtwMargin"), static_cast<float>(margin.x),
    static_cast<float>(margin.y));
  Dispatch(1);
}

glm::dvec2 PerspectiveWarpStage::ReadGreatestDensity(int layer) const
{
  glm::dvec2 density(1);
  if (layer >= 0 && layer < this->Layers)
  {
    glm::vec4 report;
    this->Report.Read(layer * sizeof(report), &report, sizeof(report));
    density = { 1 / double(report.y - report.x), 1 + double(report.z) };
  }
  return density;
}

void PerspectiveWarpStage::Dispose(Disposal dispose)
{
  dispose(this->Looking, this->Bounding, this->Building, this->Nearest, this->Bounds, this->Report);
  this->Ratio.Forget();
  this->Layers = 0;
}
}
