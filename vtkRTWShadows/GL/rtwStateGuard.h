// Lets raw OpenGL calls stand beside VTK's: while one lives VTK's idea of the state is put aside, and when it goes
// the state is as VTK left it.
#ifndef rtwStateGuard_h
#define rtwStateGuard_h

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

  /// Lets VTK draw in between, into the target and with the state that raw calls have set.
  void DrawWithVTK(const std::function<void()>& draw);
  /// Depth test and writes on, blending, culling, scissor and the stencil off.
  static void PrepareDepthDrawing(bool depthClamp);

private:
  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
};
}

#endif
