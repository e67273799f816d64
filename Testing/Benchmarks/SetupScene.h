// SPDX-License-Identifier: BSD-3-Clause
#ifndef SetupScene_h
#define SetupScene_h

#include "Setup.h"

#include "rtwScene.h"

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

/// What a setup's scene may be: any that rtw::MakeScene() knows, and rtw::MakeFloor().
std::vector<std::string> SetupSceneNames();

/// Makes the scene of a setup. The last one is kept, since the next setup often wants it again.
std::shared_ptr<const rtw::Scene> SceneOf(const Setup& setup);

/// Puts it into a renderer: the scene, copies behind the camera, more lights.
void Populate(const Setup& setup, const rtw::Scene& scene, vtkRenderer* renderer);

/// Where on a setup's way, 0 to 1, its frames are: as many as one likes, spread evenly, and the
/// first of them the same however many there are.
double PlaceOnWay(int i);

/// Moves what the setup moves to a place on its way, and from there by tiny steps.
class Mover
{
public:
  Mover(const Setup& setup, std::shared_ptr<const rtw::Scene> scene, vtkRenderer* renderer);
  void MoveTo(int place, int step);

private:
  Motion Moves;
  std::shared_ptr<const rtw::Scene> Scene;
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkActor> Actor;
  double Start[3];
  double Reach;
};

#endif
