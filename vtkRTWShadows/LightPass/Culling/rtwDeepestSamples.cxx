// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/Culling/rtwDeepestSamples.h"

#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Light/rtwSampleMoves.h"
#include "LightPass/Culling/rtwDeepest.h"
#include "LightPass/Culling/rtwMarkDeepest.h"
#include "LightPass/Culling/rtwReduceDeepest.h"

namespace rtw
{
namespace
{
// Texels a side that a work group of rtwMarkDeepest.glsl goes through.
constexpr int Tile = 64;
constexpr int LeastSquare = 2; // log2 of its side
constexpr int Unit = 8;        // the texture unit of rtwDeepest in rtwDeepestIn.glsl

// The number of least squares along a side of the map, rounded up to a power of two.
int SideOf(int texels, int square)
{
  int side = 1;
  while (side << square < texels)
  {
    side *= 2;
  }
  return side;
}
}

bool DeepestSamples::Build(const WarpShape& warp)
{
  if (this->Warp != warp.Name)
  {
    this->Marking.Release();
    this->Warp = warp.Name;
  }
  return this->Marking.Build({ { GL_COMPUTE_SHADER,
           { LayerTable::DefinitionOf(TableAccess::Storage), rtwWarpFocus, warp.Function,
             rtwViewSampleAccess, rtwLitSample, rtwSampleMoves, rtwDeepest, rtwMarkDeepest } } }) &&
    this->Reducing.Build({ { GL_COMPUTE_SHADER, { rtwDeepest, rtwReduceDeepest } } });
}

void DeepestSamples::Find(
  const LightFrame& frame, const ViewSampler& samples, const LayerTable& table, double reach)
{
  this->Square = LeastSquare;
  while ((1 << this->Square) < 2 * reach)
  {
    ++this->Square;
  }
  const int texels = table.GetResolution(), side = SideOf(texels, this->Square);
  this->Deepest.Allocate(1, std::size_t(4) * side * side / 3 + 1);
  this->Deepest.Clear();
  this->Deepest.BindStorage(0);
  this->Marking.Use();
  samples.Bind(this->Marking);
  table.Bind(this->Marking);
  BindLight(this->Marking, frame, samples.GetView(), 1);
  this->Marking.Set("rtwLayer", frame.Layer);
  this->Marking.Set("rtwSquare", this->Square);
  this->Marking.Set("rtwReach", float(reach));
  Dispatch(Groups(samples.GetWidth(), Tile), Groups(samples.GetHeight(), Tile));
  this->Reducing.Use();
  this->Reducing.Set("rtwSquare", this->Square);
  this->Reducing.Set("rtwTexels", texels);
  for (int level = 1; (side >> level) > 0; ++level)
  {
    this->Reducing.Set("rtwLevel", level);
    Dispatch(Groups(side >> level, 8), Groups(side >> level, 8));
  }
}

void DeepestSamples::Bind(const Program& program, const DeepestSamples* found)
{
  program.Set("rtwHasDeepest", found ? 1 : 0);
  if (found)
  {
    program.Set("rtwSquare", found->Square);
    found->Deepest.Bind(Unit);
  }
}

void DeepestSamples::Dispose(Disposal dispose)
{
  dispose(this->Marking, this->Reducing, this->Deepest);
}
}
