// SPDX-License-Identifier: BSD-3-Clause
#ifndef View_h
#define View_h

#include "Techniques.h"

#include <vtkNew.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;

/// Medians, in milliseconds.
struct Times
{
  double Rebuilt = 0; // a frame with shadow maps made anew
  double Still = 0;   // a frame in which nothing has changed
  std::vector<Stage> Stages;
};

/// A window of its own that shows the scene by one technique, or without shadows.
class View
{
public:
  View(const rtw::Scene& scene, const Options& options, std::string technique, int resolution);
  ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  const std::string& GetTechniqueName() const { return this->Name; }
  int GetResolution() const { return this->Resolution; }
  Technique* GetTechnique() { return this->Shadows.get(); }
  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkRenderWindow* GetWindow() { return this->Window; }

  void SetRebuilding(bool rebuilding);

  /// Draws a frame and waits for the GPU. Returns the milliseconds it took.
  double Render();

private:
  std::string Name;
  int Resolution;
  std::unique_ptr<Technique> Shadows; // empty for none
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

using Views = std::vector<std::unique_ptr<View>>;

/// Times all views frame by frame in turn, so that what disturbs the machine disturbs them alike.
std::vector<Times> TakeTimes(Views& views, const Options& options);

#endif
