// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwLightUniforms.h"

#include "Frame/rtwView.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwProgram.h"
#include "Light/rtwLightFrame.h"

#include <glm/gtc/type_ptr.hpp>

namespace rtw
{
std::array<glm::vec4, 4> SidesOf(const View& view)
{
  const glm::dmat4 rows = glm::transpose(view.ViewToClip);
  return { glm::vec4(-rows[0] - rows[3]), glm::vec4(rows[0] - rows[3]),
    glm::vec4(-rows[1] - rows[3]), glm::vec4(rows[1] - rows[3]) };
}

glm::vec4 BeamOf(const LightFrame& frame, const View& view)
{
  const glm::dvec3& direction = frame.Light.Direction;
  const double way = glm::dot(direction, view.Forward) < 0 ? -1 : 1;
  const bool isSpot = frame.Light.Kind == LightKind::Spot;
  return glm::vec4(view.WorldToView *
    (isSpot ? way * glm::dvec4(frame.Light.Position, 1) : glm::dvec4(-way * direction, 0)));
}

void BindLight(const Program& program, const LightFrame& frame, const View& view, int stride)
{
  const glm::mat4 viewToLight(frame.WorldToLight * view.ViewToWorld);
  program.SetMatrix("rtwViewToLight", glm::value_ptr(viewToLight));
  glUniform4f(program.Location("rtwCone"), float(frame.ConeCentre.x), float(frame.ConeCentre.y),
    float(frame.ConeTangent), 0.f);
  program.Set("rtwStride", stride);
  program.Set("rtwParts", frame.Parts);
  program.Set("rtwSampledLayer", frame.Layer);
  program.Set("rtwFaces", frame.Faces);
  if (frame.Faces > 1)
  {
    const glm::vec4 beam = BeamOf(frame, view);
    glUniform4fv(program.Location("rtwBeam"), 1, glm::value_ptr(beam));
    glUniform4fv(program.Location("rtwSides"), 4, glm::value_ptr(SidesOf(view)[0]));
  }
}
}
