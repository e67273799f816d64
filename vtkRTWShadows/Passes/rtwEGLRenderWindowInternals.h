// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwEGLRenderWindowInternals_h
#define rtwEGLRenderWindowInternals_h

#include "vtkRTWEGLRenderWindow.h"

#include "GL/rtwEGLContext.h"

#include <memory>
#include <string>

struct vtkRTWEGLRenderWindow::vtkInternals
{
  std::unique_ptr<rtwEGLContext> Context;

  // The request that failed last, so that it is not tried again at each frame and told but once.
  rtwEGLContext::Request FailedRequest;
  std::string WhyNot;
  bool Reported = false;

  // While resources are released, MakeCurrent must not bring a context to life.
  bool Releasing = false;

  // Whether Start() got as far as to push the framebuffer bindings that End() pops.
  bool Started = false;

  std::string Capabilities;

  // A thread that had a GLX context current before the window was used has it again after. What is
  // used within something else, as MakeCurrent in Render, does not disturb that.
  int Depth = 0;
  void BeginUse() { ++this->Depth; }
  void EndUse()
  {
    if (this->Depth > 0 && --this->Depth == 0 && this->Context)
    {
      this->Context->GiveBack();
    }
  }

  class Use
  {
  public:
    explicit Use(vtkInternals& internals)
      : Internals(internals)
    {
      this->Internals.BeginUse();
    }
    ~Use() { this->Internals.EndUse(); }
    Use(const Use&) = delete;
    void operator=(const Use&) = delete;

  private:
    vtkInternals& Internals;
  };
};

#endif
