// SPDX-License-Identifier: BSD-3-Clause
#include "rtwRectilinearWarpStage.h"

#include "rtwBendRectilinear.h"
#include "rtwBuildRectilinear.h"
#include "rtwDrawing.h"
#include "rtwOpenGL.h"
#include "rtwWarpFocus.h"
#include "rtwWarpRectilinear.h"
#include "rtwWarpTable.h"

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
  return { "rectilinear", rtwWarpRectilinear, rtwBendRectilinear };
}

int RectilinearWarpStage::GetLightImageSize() const
{
  const RectilinearSettings settings = this->Settings();
  return settings.Importance.NeedsLightImages() ? settings.LightImageSize : 0;
}

bool RectilinearWarpStage::Build()
{
  return this->Importance.Build() &&
    this->Building.Build({ { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwBuildRectilinear } } });
}

std::string RectilinearWarpStage::GetLog() const
{
  return this->Importance.GetLog() + this->Building.GetLog();
}

void RectilinearWarpStage::Run(
  const std::vector<LightFrame>& frames, const AnalysisInput& input, const WarpTable& table)
{
  const RectilinearSettings settings = this->Settings();
  this->Importance.Analyse(frames, settings.Importance, input, table);
  this->Report.Reserve(frames.size() * 2 * 2 * sizeof(float));
  this->Building.Use();
  table.Bind(this->Building);
  this->Importance.GetProfile().BindStorage(0);
  this->Report.BindStorage(1);
  table.GetValues().BindStorage(2);
  table.GetBends().BindStorage(3);
  this->Building.Set("rtwCollected", static_cast<int>(this->Importance.GetCollected()));
  this->Building.Set("rtwProfiles", this->Importance.GetProfiles());
  this->Building.Set("rtwSigma", static_cast<float>(settings.Sigma));
  this->Building.Set("rtwFloor", static_cast<float>(settings.Floor));
  this->Building.Set("rtwLevels", table.GetBendLevels());
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

void RectilinearWarpStage::Release()
{
  this->Importance.Release();
  this->Building.Release();
  this->Report.Release();
}

void RectilinearWarpStage::Abandon()
{
  this->Importance.Abandon();
  this->Building.Abandon();
  this->Report.Abandon();
}
}
