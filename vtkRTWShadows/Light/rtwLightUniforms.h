// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwLightUniforms_h
#define rtwLightUniforms_h

#include <glm/glm.hpp>

#include <array>

namespace rtw
{
class Program;
struct LightFrame;
struct View;

/// Tells an analysis (rtwLitSample.glsl, rtwBackwardSample.glsl) for which light it looks at the
/// view samples.
void BindLight(const Program& program, const LightFrame& frame, const View& view, int stride);

/// The planes of the sides of the view frustum, in view coordinates, positive outside.
std::array<glm::vec4, 4> SidesOf(const View& view);
/// The `beam` of rtwFaceAt() in rtwLayerInterval.glsl: which way it goes along a light's beams.
glm::vec4 BeamOf(const LightFrame& frame, const View& view);
}

#endif
