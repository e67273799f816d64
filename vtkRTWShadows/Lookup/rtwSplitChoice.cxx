// SPDX-License-Identifier: BSD-3-Clause
#include "Lookup/rtwSplitChoice.h"

#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwShadowEdge.h"
#include "Lookup/rtwMapOfLight.h"
#include "Lookup/rtwSplitErrors.h"
#include "Warp/Perspective/rtwResolutionSplit.h"

#include <cmath>
#include <cstring>

namespace rtw
{
namespace
{
constexpr int Steps = SplitSteps; // ratios on either side of 1
constexpr int Splits = 2 * Steps + 1;
constexpr std::int64_t Lasting = 8; // frames that a viewer is remembered for
}

void SplitChoice::Begin(bool used, const void* viewer, std::uint64_t settings)
{
  if (!used || settings != this->Settings)
  {
    this->Forget(Disposal::Release());
  }
  this->Used = used;
  this->Viewer = viewer;
  this->Settings = settings;
  if (!used)
  {
    return;
  }
  View& view = this->Views[viewer];
  view.Time = ++this->Time;
  for (auto other = this->Views.begin(); other != this->Views.end();)
  {
    const bool isGone = this->Time - other->second.Time >= Lasting;
    if (isGone)
    {
      other->second.Answer.Release();
    }
    other = isGone ? this->Views.erase(other) : std::next(other);
  }
  if (view.Answer.IsReady())
  {
    this->Take(view);
  }
}

double SplitChoice::GetRatio() const
{
  return std::exp2(double(this->Split.value_or(0)) / SteadyRatio::StepsAnOctave);
}

bool SplitChoice::IsUndecided() const
{
  const auto view = this->Views.find(this->Viewer);
  return this->Used && view != this->Views.end() && !view->second.Decided;
}

bool SplitChoice::IsToAsk(std::uint64_t signature, const WarpShape& warp)
{
  if (!this->Used)
  {
    return false;
  }
  if (!this->Warp || std::strcmp(this->Warp, warp.Name) != 0)
  {
    this->Comparing.Release();
    this->Warp = warp.Name;
  }
  const View& view = this->Views[this->Viewer];
  const std::string definitions = "#define RTW_SPLITS " + std::to_string(Splits) + "\n";
  return !view.Answer.IsUnderWay() && view.Asked != signature && this->Edges.Build() &&
    this->Comparing.Build({ { GL_COMPUTE_SHADER,
      { definitions.c_str(), rtwWarpFocus, rtwLayerInterval, warp.Function, warp.Slope,
        rtwShadowEdge, rtwSplitErrors } } });
}

void SplitChoice::Ask(
  const std::vector<MapOfLight>& lights, const TurnInput& input, std::uint64_t signature)
{
  View& view = this->Views[this->Viewer];
  view.Asked = signature;
  std::vector<float> texels;
  for (int split = -Steps; split <= Steps; ++split)
  {
    const double longer = std::exp2(0.5 * split / SteadyRatio::StepsAnOctave);
    texels.push_back(float(1 / (longer * input.Texels)));
    texels.push_back(float(longer / input.Texels));
  }
  this->Errors.Assign(std::vector<float>(Splits, 0.f));
  for (const MapOfLight& light : lights)
  {
    this->Edges.List(light.Frame, light.Frame.Number(), input);
    light.Use(this->Comparing);
    this->Edges.BindList(this->Comparing);
    this->Errors.BindStorage(1);
    glUniform2fv(this->Comparing.Location("rtwTexelSizes"), Splits, texels.data());
    Dispatch(Splits);
  }
  view.Answer.Start(this->Errors, Splits * sizeof(float));
}

void SplitChoice::Take(View& view)
{
  std::vector<float> errors(Splits);
  if (view.Answer.Read(errors.data()))
  {
    view.Errors = errors;
    this->Choose();
  }
}

void SplitChoice::Choose()
{
  std::vector<std::vector<float>> all;
  for (const auto& view : this->Views)
  {
    if (!view.second.Errors.empty())
    {
      all.push_back(view.second.Errors);
    }
  }
  this->Split = LeastErrorStep(all, this->Split);
}

bool SplitChoice::Wait()
{
  View& view = this->Views[this->Viewer];
  const double before = this->GetRatio();
  this->Take(view);
  view.Decided = true; // even if in vain: it isn't tried in each frame
  return this->GetRatio() != before;
}

void SplitChoice::Forget(Disposal dispose)
{
  for (auto& view : this->Views)
  {
    dispose(view.second.Answer);
  }
  this->Views.clear();
  this->Split.reset();
}

void SplitChoice::Dispose(Disposal dispose)
{
  dispose(this->Edges, this->Comparing, this->Errors);
  this->Forget(dispose);
}
}
