// SPDX-License-Identifier: BSD-3-Clause
// While one lives, the current OpenGL context is in a state that nobody expects: something is bound
// everywhere, and settings are such as nothing draws with. VTK's record of it is true. When it goes
// all is as before. It needs OpenGL 4.3.
#ifndef rtwOddState_h
#define rtwOddState_h

#include <vector>

class vtkOpenGLRenderWindow;

class rtwOddState
{
public:
  explicit rtwOddState(vtkOpenGLRenderWindow* window);
  ~rtwOddState();
  rtwOddState(const rtwOddState&) = delete;
  void operator=(const rtwOddState&) = delete;

private:
  void MakeTextures();
  void BindTextures();
  void BindBuffers();
  void BindObjects();
  void SetRecorded();
  static void SetUnrecorded(bool odd);

  vtkOpenGLRenderWindow* Window;
  std::vector<unsigned int> Textures, BoundTextures, BoundSamplers, BoundBuffers;
  unsigned int Buffer = 0, Sampler = 0, VertexArray = 0, Renderbuffer = 0, Feedback = 0, Program = 0;
  unsigned int Queries[2];
};

#endif
