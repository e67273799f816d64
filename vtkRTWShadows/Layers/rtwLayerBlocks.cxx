// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/rtwLayerBlocks.h"

#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwProgram.h"

#include <cstdint>
#include <vector>

namespace rtw
{
namespace
{
constexpr int BlockSide = 4; // samples along a side of a block; BLOCK of rtwSampleBlocks.glsl
constexpr int GroupSize = 256;
constexpr unsigned int ListBinding = 4; // as in rtwVisitSamples.glsl
constexpr int HeaderLength = 4;
}

int LayerBlocks::Count(const ViewSampler& samples, int stride)
{
  return Groups(Groups(samples.GetWidth(), stride), BlockSide) *
    Groups(Groups(samples.GetHeight(), stride), BlockSide);
}

void LayerBlocks::Start(int layers, const ViewSampler& samples, int stride)
{
  this->Layers = layers;
  this->Blocks = Count(samples, stride);
  this->Stride = stride;
  this->Width = samples.GetWidth();
  this->Height = samples.GetHeight();
  std::vector<std::uint32_t> headers;
  for (int layer = 0; layer < layers; ++layer)
  {
    headers.insert(headers.end(), { 0, 1, 1, 0 });
  }
  this->Lists.Reserve(sizeof(std::uint32_t) * layers * (HeaderLength + std::size_t(this->Blocks)));
  this->Lists.Write(0, headers.data(), headers.size() * sizeof(headers[0]));
}

void LayerBlocks::BindForListing(const Program& program) const
{
  this->Lists.BindStorage(ListBinding);
  program.Set("rtwFirstList", HeaderLength * this->Layers);
}

bool LayerBlocks::Holds(const ViewSampler& samples, int stride, int layer) const
{
  return layer >= 0 && layer < this->Layers && stride == this->Stride &&
    samples.GetWidth() == this->Width && samples.GetHeight() == this->Height;
}

void LayerBlocks::Dispatch(
  const Program& program, const ViewSampler& samples, int stride, int layer) const
{
  if (!this->Holds(samples, stride, layer))
  {
    program.Set("rtwBlockList", -1);
    rtw::Dispatch(Groups(Count(samples, stride), GroupSize));
    return;
  }
  this->Lists.BindStorage(ListBinding);
  program.Set("rtwBlockList", HeaderLength * layer);
  program.Set("rtwListedBlocks", HeaderLength * this->Layers + layer * this->Blocks);
  DispatchIndirect(this->Lists, sizeof(std::uint32_t) * HeaderLength * layer);
}

void LayerBlocks::Dispose(Disposal dispose)
{
  dispose(this->Lists);
  this->Forget();
}
}
