// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwLightUniforms_h
#define rtwLightUniforms_h

namespace rtw
{
class Program;
struct LightFrame;
struct View;

/// Tells an analysis (rtwLitSample.glsl, rtwBackwardSample.glsl) for which light it looks at the
/// view samples.
void BindLight(const Program& program, const LightFrame& frame, const View& view, int stride);
}

#endif
