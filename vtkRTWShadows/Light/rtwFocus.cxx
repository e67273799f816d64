// SPDX-License-Identifier: BSD-3-Clause
#include "rtwFocus.h"

#include "rtwBackwardSample.h"
#include "rtwDrawing.h"
#include "rtwFocusReduction.h"
#include "rtwFocusWrite.h"
#include "rtwLightUniforms.h"
#include "rtwLitSample.h"
#include "rtwOpenGL.h"
#include "rtwPlacedOnPlane.h"
#include "rtwSamplePlace.h"
#include "rtwViewSampleAccess.h"
#include "rtwViewSampler.h"
#include "rtwWarpFocus.h"
#include "rtwWarpTable.h"

#include <cstdint>
#include <cstring>

namespace rtw
{
namespace
{
constexpr float Margin = 1e-4f; // of the focus' extent, for rounding
constexpr int Tile = 64;        // as in rtwBackwardSample.glsl

// An order that floats and unsigned integers share, as in the shader.
std::uint32_t Ordered(double value)
{
  const auto x = static_cast<float>(value);
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

void SetWholeBounds(const Program& program, const LightFrame& frame)
{
  const Rectangle& b = frame.Bounds;
  glUniform4f(program.Location("rtwWholeBounds"), float(b.Low.x), float(b.Low.y), float(b.High.x),
    float(b.High.y));
}
}

bool FocusStage::Build()
{
  return this->Reduction.Build({ { GL_COMPUTE_SHADER,
           { rtwViewSampleAccess, rtwSamplePlace, rtwLitSample, rtwBackwardSample, rtwPlacedOnPlane,
             rtwFocusReduction } } }) &&
    this->Writing.Build({ { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwFocusWrite } } });
}

const std::string& FocusStage::GetLog() const
{
  return this->Reduction.IsBuilt() ? this->Writing.GetLog() : this->Reduction.GetLog();
}

void FocusStage::Reduce(const std::vector<LightFrame>& frames, const std::vector<Rectangle>& also,
  const ViewSampler& samples, int stride, const FilterReach& filter, const WarpTable& table)
{
  std::vector<std::uint32_t> start;
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    const Rectangle& r = also[layer];
    const bool any = r.Low.x <= r.High.x;
    for (int k = 0; k < 2; ++k)
    {
      start.push_back(any ? Ordered(r.Low[k]) : 0xffffffffu);
    }
    for (int k = 0; k < 2; ++k)
    {
      start.push_back(any ? Ordered(r.High[k]) : 0u);
    }
    start.insert(start.end(), { 0xffffffffu, 0xffffffffu, 0u, 0u });
  }
  this->Bounds.Assign(start);
  this->Bounds.BindStorage(0);
  this->Reduction.Use();
  samples.Bind(this->Reduction);
  this->Reduction.Set("rtwFilterWidth", float(filter.World));
  const int columns = Groups(Groups(samples.GetWidth(), stride), Tile);
  const int rows = Groups(Groups(samples.GetHeight(), stride), Tile);
  this->Tiles.Reserve(sizeof(glm::vec4) * columns * rows);
  this->Tiles.BindStorage(1);
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    BindLight(this->Reduction, frames[layer], samples.GetView(), stride);
    SetWholeBounds(this->Reduction, frames[layer]);
    this->Reduction.Set("rtwLayer", static_cast<int>(layer));
    for (int pass = 0; pass < (stride > 1 ? 2 : 1); ++pass)
    {
      this->Reduction.Set("rtwClosely", pass);
      Dispatch(columns, rows);
    }
  }
  this->Writing.Use();
  table.Bind(this->Writing);
  table.GetValues().BindStorage(1);
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    SetWholeBounds(this->Writing, frames[layer]);
    this->Writing.Set("rtwLayer", static_cast<int>(layer));
    this->Writing.Set("rtwMargin", Margin + float(filter.Share));
    Dispatch(1);
  }
}

void FocusStage::Release()
{
  this->Reduction.Release();
  this->Writing.Release();
  this->Bounds.Release();
  this->Tiles.Release();
}

void FocusStage::Abandon()
{
  this->Reduction.Abandon();
  this->Writing.Abandon();
  this->Bounds.Abandon();
  this->Tiles.Abandon();
}
}
