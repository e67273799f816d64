// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwGLXContext_h
#define rtwGLXContext_h

#include <memory>

/**
 * The GLX context that a thread has current, put aside. A thread has room for one context, of GLX
 * or of EGL, and neither will take the place of the other: that is an error, for GLX one that ends
 * the process. So whoever draws by EGL in a program with X windows must make room, and then give
 * the place back.
 *
 * Nothing here links to GLX: its functions are looked up, since where they are not there is no
 * context of theirs either.
 */
class rtwGLXContext
{
public:
  /** Puts the current GLX context aside; null if there is none. */
  static std::unique_ptr<rtwGLXContext> Take();

  /** It is not to be made current again. */
  void Forget() { this->Context = nullptr; }

  /** Makes it current again. No context of another kind may be current. */
  ~rtwGLXContext();

  rtwGLXContext(const rtwGLXContext&) = delete;
  void operator=(const rtwGLXContext&) = delete;

private:
  rtwGLXContext() = default;
  void* Display = nullptr;
  unsigned long Drawable = 0;
  void* Context = nullptr;
};

#endif
