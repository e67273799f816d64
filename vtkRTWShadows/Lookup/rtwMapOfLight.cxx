// SPDX-License-Identifier: BSD-3-Clause
#include "Lookup/rtwMapOfLight.h"

#include "Frame/rtwViewSampler.h"
#include "GL/rtwProgram.h"
#include "Layers/rtwLayerTable.h"
#include "Light/rtwLightUniforms.h"

namespace rtw
{
void MapOfLight::Use(const Program& program) const
{
  program.Use();
  this->Samples.Bind(program);
  this->Table.Bind(program);
  BindLight(program, this->Frame, this->Samples.GetView(), 1);
  program.Set("rtwFirstLayer", this->Frame.Layer);
  program.Set("rtwMaskLayer", this->Frame.Number());
}
}
