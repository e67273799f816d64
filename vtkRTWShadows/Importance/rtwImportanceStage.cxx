// SPDX-License-Identifier: BSD-3-Clause
#include "rtwImportanceStage.h"

#include "rtwDrawing.h"
#include "rtwImportance.h"
#include "rtwLightUniforms.h"
#include "rtwLitSample.h"
#include "rtwOpenGL.h"
#include "rtwViewSampleAccess.h"
#include "rtwViewSampler.h"
#include "rtwWarpFocus.h"
#include "rtwWarpTable.h"

namespace rtw
{
namespace
{
constexpr int Tile = 64;           // as in rtwImportance.glsl
constexpr float NormalBonus = 2.f; // β (Rosen 2012, section 5.4)

// The distance from which on a window's near plane shows, for a scale that keeps numbers near 1.
float NearestDistance(const View& view)
{
  const glm::dvec4 nearest = view.ClipToView * glm::dvec4(0, 0, -1, 1);
  return float(-nearest.z / nearest.w);
}
}

bool ImportanceStage::Build()
{
  return this->Analysis.Build(
    { { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwViewSampleAccess, rtwLitSample, rtwImportance } } });
}

void ImportanceStage::Analyse(const std::vector<LightFrame>& frames, int functions,
  const ViewSampler& samples, int stride, const WarpTable& table)
{
  const std::size_t numbers = std::size_t(2) * 2 * table.GetCells() * frames.size();
  this->Profile.Reserve(numbers * sizeof(unsigned int));
  this->Profile.Clear();
  this->Analysis.Use();
  this->Profile.BindStorage(0);
  samples.Bind(this->Analysis);
  table.Bind(this->Analysis);
  this->Analysis.Set("rtwFunctions", functions);
  this->Analysis.Set("rtwBeta", NormalBonus);
  this->Analysis.Set("rtwNearest", NearestDistance(samples.GetView()));
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    BindLight(this->Analysis, frames[layer], samples.GetView(), stride);
    this->Analysis.Set("rtwLayer", static_cast<int>(layer));
    Dispatch(Groups(samples.GetWidth() / stride, Tile), Groups(samples.GetHeight() / stride, Tile));
  }
}

void ImportanceStage::Release()
{
  this->Analysis.Release();
  this->Profile.Release();
}

void ImportanceStage::Abandon()
{
  this->Analysis.Abandon();
  this->Profile.Abandon();
}
}
