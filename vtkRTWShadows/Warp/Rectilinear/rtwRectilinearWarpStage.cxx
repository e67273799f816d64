// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Rectilinear/rtwRectilinearWarpStage.h"

#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Importance/rtwAnalysisInput.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwWarpFocus.h"
#include "Warp/Rectilinear/rtwBendRectilinear.h"
#include "Warp/Rectilinear/rtwBuildRectilinear.h"
#include "Warp/Rectilinear/rtwCullCells.h"
#include "Warp/Rectilinear/rtwFollowWarp.h"
#include "Warp/Rectilinear/rtwLastWarp.h"
#include "Warp/Rectilinear/rtwRectilinearWarp.h"
#include "Warp/Rectilinear/rtwRunningSum.h"
#include "Warp/Rectilinear/rtwSlopeRectilinear.h"
#include "Warp/Rectilinear/rtwSnapFocus.h"
#include "Warp/Rectilinear/rtwUsedGrid.h"
#include "Warp/Rectilinear/rtwWarpHistory.h"
#include "Warp/Rectilinear/rtwWarpRectilinear.h"

#include <utility>

namespace rtw
{
RectilinearWarpStage::RectilinearWarpStage(
  std::function<RectilinearSettings()> settings, std::function<void(const std::string&)> refused)
  : Settings(std::move(settings))
  , Importance(std::move(refused))
{
}

WarpShape RectilinearWarpStage::GetShape() const
{
  return { "rectilinear", rtwWarpRectilinear, rtwBendRectilinear, rtwSlopeRectilinear };
}

int RectilinearWarpStage::GetLightImageSize() const
{
  const RectilinearSettings settings = this->Settings();
  return settings.Importance.NeedsLightImages() ? settings.LightImageSize : 0;
}

bool RectilinearWarpStage::Build()
{
  return this->Importance.Build() &&
    this->Building.Build({ { GL_COMPUTE_SHADER,
      { "#define GROUP 256\n", rtwWarpFocus, rtwRunningSum, rtwLastWarp, rtwUsedGrid,
        rtwBuildRectilinear, rtwFollowWarp, rtwCullCells } } }) &&
    this->InUse.Build() &&
    this->FocusSnapping.Build(
      { { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwLastWarp, rtwSnapFocus } } });
}

std::string RectilinearWarpStage::GetLog() const
{
  return this->Importance.GetLog() + this->Building.GetLog() + this->FocusSnapping.GetLog() +
    this->InUse.GetLog();
}

void RectilinearWarpStage::Follow(const WarpFrame& frame, const LayerTable& table)
{
  const RectilinearSettings settings = this->Settings();
  this->Settled = true;
  if (!settings.Remembers())
  {
    return;
  }
  this->History.Follow(frame, table.GetCells());
  this->Settled =
    this->History.GetStillFrames() >= FramesToSettle(settings.Blending, table.GetResolution());
  this->FocusSnapping.Use();
  table.Bind(this->FocusSnapping);
  this->History.BindStorage();
  table.GetValues().BindStorage(2);
  this->FocusSnapping.Set("rtwOtherLayers", frame.OtherLayers);
  this->FocusSnapping.Set("rtwMargin", frame.Focused ? float(SnappingMargin) : 0.f);
  this->FocusSnapping.Set("rtwGrowth", frame.Focused ? float(SnappingGrowth) : 0.f);
  this->FocusSnapping.Set("rtwLeastShare", float(SnappingLeastShare));
  Dispatch(static_cast<int>(frame.Frames.size()));
}

void RectilinearWarpStage::Run(
  const std::vector<LightFrame>& frames, const AnalysisInput& input, const LayerTable& table)
{
  const RectilinearSettings settings = this->Settings();
  this->Importance.Analyse(frames, settings.Importance, input, table);
  const bool cullsCells = settings.CullsCells && input.AreAll;
  if (cullsCells)
  {
    this->InUse.Find(frames, input, table);
  }
  this->Report.Reserve(frames.size() * 2 * 2 * sizeof(float));
  this->Cells = table.GetCells();
  this->Layers = static_cast<int>(frames.size());
  this->Profiles.Reserve(frames.size() * 2 * 2 * this->Cells * sizeof(float));
  this->Building.Use();
  table.Bind(this->Building);
  this->Importance.GetProfile().BindStorage(0);
  this->Report.BindStorage(1);
  table.GetValues().BindStorage(2);
  table.GetBends().BindStorage(3);
  this->Profiles.BindStorage(4);
  this->Building.Set("rtwCollected", static_cast<int>(this->Importance.GetCollected()));
  this->Building.Set("rtwUnit", static_cast<float>(this->Importance.GetUnit()));
  this->Building.Set("rtwProfiles", this->Importance.GetProfiles());
  this->Building.Set("rtwSigma", static_cast<float>(settings.Sigma));
  this->Building.Set("rtwFloor", static_cast<float>(settings.Floor));
  this->Building.Set("rtwLevels", table.GetBendLevels());
  this->Building.Set("rtwLeast", static_cast<float>(LeastShare));
  this->Building.Set("rtwCulling", cullsCells ? 1 : 0);
  if (cullsCells)
  {
    this->InUse.BindBits();
    this->Building.Set("rtwReach",
      static_cast<float>((input.FilterTexels + NeighbourReach) / table.GetResolution()));
  }
  this->Building.Set("rtwRemembers", settings.Remembers() ? 1 : 0);
  if (settings.Remembers())
  {
    this->History.BindStorage();
    this->Building.Set("rtwSnapping", settings.Snapping ? 1 : 0);
    this->Building.Set("rtwBlending", static_cast<float>(settings.Blending));
    this->Building.Set("rtwMostExcess", static_cast<float>(SnappingMostExcess));
  }
  Dispatch(2, static_cast<int>(frames.size()));
}

glm::dvec2 RectilinearWarpStage::ReadGreatestDensity(int layer) const
{
  float report[4] = { 1, 1, 1, 1 };
  const std::size_t offset = layer * sizeof(report);
  if (offset + sizeof(report) <= this->Report.GetSize())
  {
    this->Report.Read(offset, report, sizeof(report));
  }
  return { report[0], report[2] };
}

std::vector<float> RectilinearWarpStage::ReadImportance(int layer, const LayerTable&) const
{
  std::vector<float> values;
  if (layer >= 0 && layer < this->Layers)
  {
    values.resize(std::size_t(4) * this->Cells);
    const std::size_t bytes = values.size() * sizeof(float);
    this->Profiles.Read(layer * bytes, values.data(), bytes);
  }
  return values;
}

void RectilinearWarpStage::Dispose(Disposal dispose)
{
  dispose(this->Importance, this->Building, this->FocusSnapping, this->History, this->InUse,
    this->Report, this->Profiles);
  this->Layers = 0;
}
}
