// SPDX-License-Identifier: BSD-3-Clause
// Lets raw OpenGL calls stand beside VTK's: while one lives VTK's idea of the state is put aside, and when it goes
// the state is as it was before, and VTK's idea of it is true.
#ifndef rtwStateGuard_h
#define rtwStateGuard_h

#include "GL/rtwStateRecord.h"

#include <functional>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;

namespace rtw
{
class StateGuard
{
public:
  explicit StateGuard(vtkOpenGLRenderWindow* window);
  ~StateGuard();
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

  /// Lets VTK draw in between, into the target and with the settings that raw calls have made, but with all bound that
  /// VTK has bound.
  void DrawWithVTK(const std::function<void()>& draw);
  /// Depth test and writes on, blending, culling, scissor and the stencil off.
  static void PrepareDepthDrawing(bool depthClamp);

private:
  /// What a draw uses, which vtkOpenGLState would bind again even if it has been deleted.
  struct DrawObjects
  {
    unsigned int Program, Vertices, ArrayBuffer;

    static DrawObjects Bound();
    void Bind() const; ///< those that still are
  };
  void Unbind();

  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
  DrawObjects Before;
  StateRecord Changed;
  StateRecord::Scope Taking;
};
}

#endif
