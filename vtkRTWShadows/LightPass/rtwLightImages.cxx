// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/rtwLightImages.h"

#include "Warp/Identity/rtwIdentityWarpStage.h"

namespace rtw
{
bool LightImages::Build()
{
  return this->Casters.Build(IdentityWarpStage().GetShape(), TableAccess::Storage);
}

void LightImages::Start(int size, int lights, const LayerTable& focused)
{
  this->Images.Allocate(glm::ivec2(size), lights);
  this->Table.Allocate(1, size, lights, 0, false);
  this->Table.CopyFocus(focused, lights);
}

bool LightImages::Draw(const GeometryStore& store, const LightFrame& frame, int light, bool cull)
{
  if (!this->Images.BindTarget(light))
  {
    return false;
  }
  this->Casters.StartLayer(light);
  this->Casters.Draw(store, this->Table, frame, light, { cull, Bending::Linear });
  return true;
}

std::size_t LightImages::GetMemory() const
{
  return this->Images.GetMemory() + this->Table.GetMemory() + this->Casters.GetMemory();
}

void LightImages::Dispose(Disposal dispose)
{
  dispose(this->Images, this->Table, this->Casters);
}
}
