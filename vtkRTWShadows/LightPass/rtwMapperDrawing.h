// SPDX-License-Identifier: BSD-3-Clause
// Draws through VTK's own mappers what only they know how to draw.
#ifndef rtwMapperDrawing_h
#define rtwMapperDrawing_h

#include "Frame/rtwFrameScene.h"
#include "Light/rtwLightFrame.h"

#include <vector>

class vtkRenderer;

namespace rtw
{
struct View;

/// Draws the casters among the props as the light sees them, translucent ones as if they were
/// opaque. The clip coordinates are those of the light plane; rtwPlaceCaster.glsl takes them onto
/// the map.
void DrawMapperCasters(
  vtkRenderer* renderer, const std::vector<SceneProp>& props, const LightFrame& frame);
/// Draws the opaque ones among the props as the camera sees them, in the depths of a view that is
/// framed; those that receive nothing hide what is behind them.
void DrawMapperSamples(
  vtkRenderer* renderer, const std::vector<SceneProp>& props, const View& view);
}

#endif
