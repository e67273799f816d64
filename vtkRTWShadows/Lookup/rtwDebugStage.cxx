// SPDX-License-Identifier: BSD-3-Clause
#include "rtwDebugStage.h"

#include "rtwAliasingError.h"
#include "rtwAliasingErrorFS.h"
#include "rtwDebugColours.h"
#include "rtwDebugViewFS.h"
#include "rtwLayerInterval.h"
#include "rtwLightUniforms.h"
#include "rtwLitSample.h"
#include "rtwMapSample.h"
#include "rtwMaskValue.h"
#include "rtwOpenGL.h"
#include "rtwSampleDepth.h"
#include "rtwSampleMoves.h"
#include "rtwScreenVS.h"
#include "rtwTexture.h"
#include "rtwViewSampleAccess.h"
#include "rtwViewSampler.h"
#include "rtwWarpFocus.h"
#include "rtwWarpTable.h"

#include <cstring>
#include <utility>

namespace rtw
{
namespace
{
constexpr int MaskUnit = 1;

std::string ViewDefinitions()
{
  std::string code;
  for (const auto& [name, view] :
    { std::pair("SHADOW", DebugView::Shadow), { "ALIASING_ERROR", DebugView::AliasingError },
      { "IMPORTANCE", DebugView::Importance }, { "WARP_GRID", DebugView::WarpGrid } })
  {
    code +=
      "const int " + std::string(name) + " = " + std::to_string(static_cast<int>(view)) + ";\n";
  }
  return code;
}

bool HasSeveralSamples()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return samples > 1;
}
}

void DebuggedMap::Use(const Program& program) const
{
  program.Use();
  this->Samples.Bind(program);
  this->Table.Bind(program);
  BindLight(program, this->Frame, this->Samples.GetView(), 1);
  program.Set("rtwFirstLayer", this->Frame.Layer);
  program.Set("rtwMaskLayer", this->Frame.Number());
}

bool DebugStage::Build(const WarpShape& warp)
{
  if (!this->Warp || std::strcmp(this->Warp, warp.Name) != 0)
  {
    this->Painting.Release();
    this->Measuring.Release();
    this->Warp = warp.Name;
  }
  const std::string views = ViewDefinitions();
  return this->Painting.Build(
           { { GL_VERTEX_SHADER, { rtwScreenVS } },
             { GL_FRAGMENT_SHADER,
               { views.c_str(), rtwWarpFocus, rtwLayerInterval, warp.Function, warp.Slope,
                 rtwViewSampleAccess, rtwSampleDepth, rtwLitSample, rtwSampleMoves, rtwMapSample,
                 rtwAliasingError, rtwMaskValue, rtwDebugColours, rtwDebugViewFS } } },
           150) &&
    this->Measuring.Build(
      { { GL_VERTEX_SHADER, { rtwScreenVS } },
        { GL_FRAGMENT_SHADER,
          { rtwWarpFocus, rtwLayerInterval, warp.Function, warp.Slope, rtwViewSampleAccess,
            rtwLitSample, rtwSampleMoves, rtwMapSample, rtwAliasingError, rtwAliasingErrorFS } } },
      150);
}

void DebugStage::Paint(DebugView view, const DebuggedMap& map, const Texture& mask, double rounding)
{
  map.Use(this->Painting);
  map.Samples.BindDepth(this->Painting, -rounding);
  this->Painting.Set("rtwDebugView", static_cast<int>(view));
  this->Painting.Set("rtwOtherLayers", map.OtherLayers);
  // Samples of a pixel lie on other surfaces than its centre.
  this->Painting.Set("rtwReach", HasSeveralSamples() ? 1 : 0);
  this->Painting.Set("rtwMask", MaskUnit);
  mask.Bind(MaskUnit);
  this->Triangle.DrawOver();
}

bool DebugStage::Measure(const DebuggedMap& map, Texture& error)
{
  error.Allocate(Format::Float2, map.Samples.GetWidth(), map.Samples.GetHeight());
  if (!this->Target.BindColour(error))
  {
    return false;
  }
  map.Use(this->Measuring);
  this->Triangle.Draw();
  return true;
}

void DebugStage::Release()
{
  this->Painting.Release();
  this->Measuring.Release();
  this->Target.Release();
  this->Triangle.Release();
}

void DebugStage::Abandon()
{
  this->Painting.Abandon();
  this->Measuring.Abandon();
  this->Target.Abandon();
  this->Triangle.Abandon();
}
}
