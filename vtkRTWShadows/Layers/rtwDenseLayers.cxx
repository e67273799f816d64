// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/rtwDenseLayers.h"

namespace rtw
{
void DenseLayers::Allocate(const glm::ivec2& size, int layers)
{
  this->Depths.Allocate(Format::Depth, size.x, size.y, layers);
  this->Gradients.Allocate(Format::Half2, size.x, size.y, layers);
}

bool DenseLayers::BindTarget(int layer)
{
  if (!this->BindTargetAgain(layer))
  {
    return false;
  }
  Framebuffer::Clear(0);
  return true;
}

bool DenseLayers::BindTargetAgain(int layer)
{
  return this->Target.Bind(this->Depths, &this->Gradients, layer);
}

void DenseLayers::Dispose(Disposal dispose)
{
  dispose(this->Depths, this->Gradients, this->Target);
}
}
