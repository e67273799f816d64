// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/rtwCasterLayer.h"

#include "GL/rtwProgram.h"
#include "Layers/rtwLayerTable.h"
#include "LightPass/Culling/rtwDeepestSamples.h"

namespace rtw
{
namespace
{
// A bend of a quarter of a texel can be seen; a quarter of that can't.
constexpr float AllowedBendInTexels = 0.0625f;
// A triangle that is bent less than that is straight whatever its slope.
constexpr float LeastBendInTexels = 0.005f;
// The share of the distance at which a spot's depths start below which a caster is part of the
// lamp.
constexpr double NearestWShare = 0.01;
}

float NearestW(const LightFrame& frame)
{
  return frame.Light.Kind == LightKind::Spot ? float(NearestWShare * frame.NearestDistance) : 0.5f;
}

float CasterLayer::LeastBend() const
{
  return LeastBendInTexels / float(this->Table.GetResolution());
}

void CasterLayer::Prepare(const Program& program) const
{
  program.Use();
  this->Table.Bind(program);
  this->Table.BindLayer(this->Index);
  DeepestSamples::Bind(program, this->Deepest);
  program.Set("rtwLayer", this->Index);
  program.Set("rtwNearestW", NearestW(this->Frame));
  const float allowed = this->Bends == Bending::Exact
    ? this->LeastBend()
    : AllowedBendInTexels / float(this->Table.GetResolution());
  program.Set("rtwAllowedBend", allowed);
  program.Set("rtwTessellating", this->Bends == Bending::Tessellated ? 1 : 0);
  program.Set("rtwEdgeLength", float(this->EdgeLength));
}
}
