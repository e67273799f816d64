// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwTechniqueView_h
#define rtwTechniqueView_h

#include "rtwTechnique.h"

#include <vtkNew.h>

#include <functional>
#include <memory>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;

namespace rtw
{
/// What a frame took, in milliseconds.
struct FrameTime
{
  double Wall = 0; // until the GPU has finished it
  double Cpu = 0;  // of the calling thread, which prepares and submits it
  /// What ratios are made of: the wall time, but on software renderers, whose threads share the
  /// processor with all else that runs, the CPU time of all threads.
  double Work = 0;
  double Gpu = 0; // between two time stamps of the GPU; 0 if there are none
};

/// A window of its own that shows a scene by one technique, or without shadows.
class TechniqueView
{
public:
  /// `populate` puts scene, camera and light into the renderer; an empty technique is no shadows.
  /// Throws std::runtime_error if OpenGL does not work here.
  TechniqueView(int width, int height, const std::function<void(vtkRenderer*)>& populate,
    std::unique_ptr<Technique> technique);
  ~TechniqueView();
  TechniqueView(const TechniqueView&) = delete;
  TechniqueView& operator=(const TechniqueView&) = delete;

  Technique* GetTechnique() { return this->Shadows.get(); } // null for none
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }

  void SetRebuilding(bool rebuilding);

  /// Draws a frame and waits for the GPU.
  FrameTime Render();

  std::vector<Stage> GetStages();

private:
  std::unique_ptr<Technique> Shadows;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  bool IsSoftware = false;
};
}

#endif
