// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/rtwSampleBounds.h"

#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwBoundBlocks.h"
#include "Layers/rtwFocusBounds.h"
#include "Layers/rtwHeldSample.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwOrdered.h"
#include "Layers/rtwSampleBlocks.h"
#include "Layers/rtwSampleOfLayer.h"
#include "Layers/rtwUniteBlocks.h"
#include "Layers/rtwVisitBlocks.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwBackwardSample.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"

#include <cstdint>
#include <vector>

namespace rtw
{
namespace
{
constexpr int GroupSize = 256; // of rtwBoundBlocks.glsl and rtwUniteBlocks.glsl
// Blocks of each invocation; BLOCKS of rtwUniteBlocks.glsl.
constexpr int BlocksEach = 8;
// Bits of 1e30f, which the shaders take for infinity.
constexpr std::uint32_t Infinite = 0x7149f2cau;
constexpr std::size_t BlockBytes = 48;
constexpr std::size_t HeaderBytes = 16;
}

bool SampleBounds::Build(const std::string& placing)
{
  return this->Bounding.Build({ { GL_COMPUTE_SHADER,
           { rtwWarpFocus, rtwViewSampleAccess, rtwSamplePlace, rtwLitSample, rtwBackwardSample,
             rtwSampleBlocks, rtwOrdered, rtwFocusBounds, placing.c_str(), rtwHeldSample,
             rtwBoundBlocks } } }) &&
    this->Uniting.Build({ { GL_COMPUTE_SHADER,
      { rtwWarpFocus, rtwLayerInterval, rtwOrdered, rtwFocusBounds, rtwUniteBlocks } } }) &&
    this->Visiting.Build({ { GL_COMPUTE_SHADER,
      { rtwWarpFocus, rtwLayerInterval, rtwViewSampleAccess, rtwSamplePlace, rtwLitSample,
        rtwSampleOfLayer, rtwBackwardSample, rtwSampleBlocks, rtwOrdered, rtwFocusBounds,
        placing.c_str(), rtwHeldSample, rtwVisitBlocks } } });
}

std::string SampleBounds::GetLog() const
{
  return this->Bounding.GetLog() + this->Uniting.GetLog() + this->Visiting.GetLog();
}

void SampleBounds::Start(const BoundedSamples& input, int lights, int parts)
{
  const std::size_t blocks = LayerBlocks::Count(input.Samples, input.Stride);
  std::vector<std::uint32_t> start;
  for (int light = 0; light < lights; ++light)
  {
    start.insert(start.end(), { Infinite, 0u });
  }
  this->Range.Assign(start);
  this->Blocks.Reserve(BlockBytes * blocks * lights);
  this->Visits.Reserve(2 * HeaderBytes + sizeof(std::uint32_t) * blocks * parts);
}

void SampleBounds::Bind(const Program& program, const BoundedSamples& input,
  const LightFrame& frame, const Rectangle& whole) const
{
  program.Use();
  input.Samples.Bind(program);
  input.Table.Bind(program);
  BindLight(program, frame, input.Samples.GetView(), input.Stride);
  glUniform4f(program.Location("rtwWholeBounds"), float(whole.Low.x), float(whole.Low.y),
    float(whole.High.x), float(whole.High.y));
  program.Set("rtwFilterWidth", input.FilterWidth);
  program.Set("rtwLayer", frame.Layer);
  program.Set("rtwNumberOfBlocks", LayerBlocks::Count(input.Samples, input.Stride));
}

void SampleBounds::Bound(
  const BoundedSamples& input, const LightFrame& frame, int light, const Rectangle& whole)
{
  const int blocks = LayerBlocks::Count(input.Samples, input.Stride);
  this->Bind(this->Bounding, input, frame, whole);
  this->Blocks.BindStorage(1);
  this->Range.BindStorage(2);
  this->Bounding.Set("rtwFirstBlock", light * blocks);
  this->Bounding.Set("rtwLight", light);
  Dispatch(Groups(blocks, GroupSize));
}

void SampleBounds::Unite(const BoundedSamples& input, const LightFrame& frame, int light, int parts,
  const Rectangle& whole, const Buffer& bounds, const LayerBlocks* lists)
{
  const int blocks = LayerBlocks::Count(input.Samples, input.Stride);
  const std::uint32_t none[] = { 0, 1, 1, 0, 0, 1, 1, 0 };
  this->Visits.Write(0, none, sizeof(none));
  bounds.BindStorage(0);
  this->Blocks.BindStorage(1);
  this->Visits.BindStorage(2);
  for (int pass = 0; pass < (input.Stride > 1 ? 2 : 1); ++pass)
  {
    this->Bind(this->Uniting, input, frame, whole);
    this->Uniting.Set("rtwFirstBlock", light * blocks);
    this->Uniting.Set("rtwPass", pass);
    this->Uniting.Set("rtwFirstList", -1);
    if (lists)
    {
      lists->BindForListing(this->Uniting);
    }
    Dispatch(Groups(blocks, GroupSize * BlocksEach), parts);
    this->Bind(this->Visiting, input, frame, whole);
    this->Visiting.Set("rtwPass", pass);
    DispatchIndirect(this->Visits, pass * HeaderBytes);
  }
}

void SampleBounds::Dispose(Disposal dispose)
{
  dispose(this->Bounding, this->Uniting, this->Visiting, this->Blocks, this->Range, this->Visits);
}
}
