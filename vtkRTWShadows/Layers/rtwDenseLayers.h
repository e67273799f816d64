// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps as layers of one texture array: depth, and the occluder's depth gradient beside it.
#ifndef rtwDenseLayers_h
#define rtwDenseLayers_h

#include "GL/rtwFramebuffer.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexture.h"

#include <glm/glm.hpp>

#include <cstddef>

namespace rtw
{
class DenseLayers
{
public:
  /// Makes layers of so many texels along s and t.
  void Allocate(const glm::ivec2& size, int layers);
  /// Makes a layer the target of drawing, cleared: nothing casts yet.
  bool BindTarget(int layer);
  bool BindTargetAgain(int layer);
  const Texture& GetDepths() const { return this->Depths; }
  const Texture& GetGradients() const { return this->Gradients; }
  glm::ivec2 GetSize() const { return { this->Depths.GetWidth(), this->Depths.GetHeight() }; }
  int GetNumberOfLayers() const { return this->Depths.GetLayers(); }
  std::size_t GetMemory() const { return this->Depths.GetMemory() + this->Gradients.GetMemory(); }
  void Dispose(Disposal dispose);

private:
  Texture Depths, Gradients;
  Framebuffer Target;
};
}

#endif
