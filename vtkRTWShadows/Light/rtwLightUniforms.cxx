// SPDX-License-Identifier: BSD-3-Clause
#include "rtwLightUniforms.h"

#include "rtwLightFrame.h"
#include "rtwOpenGL.h"
#include "rtwProgram.h"
#include "rtwView.h"

#include <glm/gtc/type_ptr.hpp>

namespace rtw
{
void BindLight(const Program& program, const LightFrame& frame, const View& view)
{
  const glm::mat4 viewToLight(frame.WorldToLight * view.ViewToWorld);
  const bool spot = frame.Light.Kind == LightKind::Spot;
  const glm::vec4 towards(view.WorldToView *
    (spot ? glm::dvec4(frame.Light.Position, 1) : glm::dvec4(-frame.Light.Direction, 0)));
  program.SetMatrix("rtwViewToLight", glm::value_ptr(viewToLight));
  program.Set("rtwCone", float(frame.ConeCentre.x), float(frame.ConeCentre.y),
    float(frame.ConeTangent));
  glUniform4f(
    program.Location("rtwTowardsLight"), towards.x, towards.y, towards.z, spot ? 1.f : 0.f);
}
}
