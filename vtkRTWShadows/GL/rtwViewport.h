// SPDX-License-Identifier: BSD-3-Clause
// The viewport that VTK draws into.
#ifndef rtwViewport_h
#define rtwViewport_h

#include <glm/glm.hpp>

class vtkOpenGLRenderWindow;

namespace rtw
{
/// The viewport that is set: its lower left corner in the target's pixels, its width and its height.
glm::ivec4 ViewportOf(vtkOpenGLRenderWindow* window);
}

#endif
