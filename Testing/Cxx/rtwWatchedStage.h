// SPDX-License-Identifier: BSD-3-Clause
// Objects under a sun and a spot, drawn while OpenGL is in an odd state; each stage of ours is
// watched, and has to leave that state as it was:
//
//     rtwWatchedStage watched(rtwTechnique::RTW, "rtw");
//     watched.Render("first frame");
//     watched.CheckReadOuts();
#ifndef rtwWatchedStage_h
#define rtwWatchedStage_h

#include "rtwShadowStage.h"

#include <functional>
#include <string>
#include <vector>

class rtwWatchedPass;
class rtwNoPass;

class rtwWatchedStage
{
public:
  rtwWatchedStage(rtwTechnique technique, const std::string& name, int samples = 0);
  ~rtwWatchedStage();
  rtwWatchedStage(const rtwWatchedStage&) = delete;
  void operator=(const rtwWatchedStage&) = delete;

  /// A frame, in an odd state or the usual one. Nothing is drawn into the picture, so that baker and
  /// pass are all that changes anything.
  void Render(const std::string& what, bool odd = true);
  /// Looks at what a frame has left behind, in an odd state.
  void Look(const std::string& what, const std::function<void()>& look);
  void CheckReadOuts();
  void CheckDebugViews();

  rtwShadowStage Stage;
  vtkAdaptiveShadowMapPass* Pass;

private:
  std::string Name;
  vtkSmartPointer<rtwNoPass> None;
  vtkSmartPointer<rtwWatchedPass> Baker, Shadows;
};

#endif
