// SPDX-License-Identifier: BSD-3-Clause
#include "rtwLightUniforms.h"

#include "rtwLightFrame.h"
#include "rtwOpenGL.h"
#include "rtwProgram.h"
#include "rtwView.h"

#include <glm/gtc/type_ptr.hpp>

namespace rtw
{
void BindLight(const Program& program, const LightFrame& frame, const View& view, int stride)
{
  const glm::mat4 viewToLight(frame.WorldToLight * view.ViewToWorld);
  program.SetMatrix("rtwViewToLight", glm::value_ptr(viewToLight));
  glUniform4f(program.Location("rtwCone"), float(frame.ConeCentre.x), float(frame.ConeCentre.y),
    float(frame.ConeTangent), 0.f);
  program.Set("rtwStride", stride);
}
}
