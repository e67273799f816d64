// SPDX-License-Identifier: BSD-3-Clause
#include "Inspect/rtwDebugStage.h"

#include "Frame/rtwSampleDepth.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwScreenVS.h"
#include "GL/rtwTexture.h"
#include "Inspect/rtwAliasingErrorFS.h"
#include "Inspect/rtwDebugViewFS.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Light/rtwSampleMoves.h"
#include "Lookup/rtwAliasingError.h"
#include "Lookup/rtwDebugColours.h"
#include "Lookup/rtwMapSample.h"
#include "Lookup/rtwMaskValue.h"

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

void DebugStage::Paint(DebugView view, const MapOfLight& map, const Texture& mask, double rounding)
{
  map.Use(this->Painting);
  map.Samples.BindDepth(this->Painting, -rounding);
  this->Painting.Set("rtwDebugView", static_cast<int>(view));
  this->Painting.Set("rtwOtherLayers", map.OtherLayers);
  // Some samples of a pixel lie on another surface than its centre.
  this->Painting.Set("rtwReach", HasSeveralSamples() ? 1 : 0);
  this->Painting.Set("rtwMask", MaskUnit);
  mask.Bind(MaskUnit);
  this->Triangle.DrawOver();
}

bool DebugStage::Measure(const MapOfLight& map, Texture& error)
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

void DebugStage::Dispose(Disposal dispose)
{
  dispose(this->Painting, this->Measuring, this->Target, this->Triangle);
}
}
