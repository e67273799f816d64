// SPDX-License-Identifier: BSD-3-Clause
// What a frame is while a vtkHardwareSelector captures it: numbers of props, cells and points, not a picture.
#ifndef rtwSelection_h
#define rtwSelection_h

class vtkRenderState;
class vtkRenderer;

namespace rtw
{
/// Draws a renderer's frame for its selector, as VTK does where the renderer has no pass: into the window, whatever
/// pass is around, and with no pass's code on the props. False, and nothing is drawn, where nobody selects.
bool RenderSelection(const vtkRenderState* state);

/// Whether what a renderer draws is for nobody's eyes: a selector captures it or another renderer of its window.
bool IsSelecting(vtkRenderer* renderer);
}

#endif
