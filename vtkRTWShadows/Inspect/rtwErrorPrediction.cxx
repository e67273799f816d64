// SPDX-License-Identifier: BSD-3-Clause
#include "Inspect/rtwErrorPrediction.h"

#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwScreenVS.h"
#include "Inspect/rtwPredictedErrorFS.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwLitSample.h"
#include "Light/rtwSampleMoves.h"
#include "Light/rtwShadowEdge.h"
#include "Lookup/rtwAliasingError.h"
#include "Lookup/rtwMapSample.h"

#include <algorithm>
#include <vector>

namespace rtw
{
namespace
{
constexpr int Square = 16; // pixels a side
constexpr int MaskUnit = 1;
constexpr int OwnMaskUnit = 2;
// The share of pixels beside an edge that is wrong where a texel's width misplaces the edge by a
// pixel, as measured against exact rays.
constexpr double WrongPerPixel = 0.148;
}

bool ErrorPrediction::Build(const WarpShape& warp)
{
  if (this->Warp != warp.Name)
  {
    this->Adding.Release();
    this->Warp = warp.Name;
  }
  const std::string definitions = "#define RTW_SQUARE " + std::to_string(Square) + "\n";
  return this->Adding.Build(
    { { GL_VERTEX_SHADER, { rtwScreenVS } },
      { GL_FRAGMENT_SHADER,
        { definitions.c_str(), rtwWarpFocus, rtwLayerInterval, warp.Function, warp.Slope,
          rtwViewSampleAccess, rtwLitSample, rtwSampleMoves, rtwMapSample, rtwAliasingError,
          rtwShadowEdge, rtwPredictedErrorFS } } },
    150);
}

// Draws a mask of the warped layer alone: shadows that it lacks are those of the layer of casters
// that only VTK's mappers draw.
bool ErrorPrediction::DrawOwnMask(const DrawnShadows& shadows, const ReceiverShape& shape)
{
  ReceiverShape own = shape;
  own.OtherLayers = false;
  if (!this->Own.Build(own, TableAccess::Texels, false))
  {
    return false;
  }
  this->Own.Render(shadows.Lights, 0, shadows.Map.Samples, shadows.Layers, shadows.Map.Table);
  return true;
}

bool ErrorPrediction::Draw(const DrawnShadows& shadows)
{
  const int width = shadows.Mask.GetWidth(), height = shadows.Mask.GetHeight();
  this->Sums.Allocate(
    Format::Float4, (width + Square - 1) / Square, (height + Square - 1) / Square);
  if (!this->Target.BindColour(this->Sums))
  {
    return false;
  }
  const Texture& own = shadows.Map.OtherLayers > 0 ? this->Own.GetMask() : shadows.Mask;
  shadows.Map.Use(this->Adding);
  shadows.Mask.Bind(MaskUnit);
  own.Bind(OwnMaskUnit);
  this->Adding.Set("rtwMask", MaskUnit);
  this->Adding.Set("rtwOwnMask", OwnMaskUnit);
  this->Adding.Set("rtwOtherLayers", shadows.Map.OtherLayers);
  this->Triangle.Draw();
  return true;
}

double ErrorPrediction::Sum() const
{
  std::vector<float> sums(std::size_t(4) * this->Sums.GetWidth() * this->Sums.GetHeight());
  this->Sums.ReadFloats(0, sums.data());
  double misplaced = 0, facing = 0;
  for (std::size_t i = 0; i < sums.size(); i += 4)
  {
    misplaced += sums[i];
    facing += sums[i + 2];
  }
  return facing > 0 ? std::min(WrongPerPixel * misplaced / facing, 1.0) : 0.0;
}

double ErrorPrediction::Predict(const DrawnShadows& shadows, const ReceiverShape& shape)
{
  const bool possible = this->Build(shape.Warp) &&
    (shadows.Map.OtherLayers == 0 || this->DrawOwnMask(shadows, shape)) && this->Draw(shadows);
  return possible ? this->Sum() : -1.0;
}

void ErrorPrediction::Dispose(Disposal dispose)
{
  dispose(this->Adding, this->Own, this->Sums, this->Target, this->Triangle);
}
}
