// SPDX-License-Identifier: BSD-3-Clause
// Views whose warps follow the last frame's, and what they would be otherwise.
#ifndef rtwWarpViews_h
#define rtwWarpViews_h

#include "rtwShadowStage.h"

#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRTWShadowMapPass.h"
#include "vtkShadowRenderStepsPass.h"

#include <array>

/// The warp of a light in a frame.
struct rtwWarp
{
  std::array<rtw::WarpingFunction, 2> Along;
  vtkNew<vtkMatrix4x4> ToPlane;

  rtwWarp() = default;
  rtwWarp(const rtwWarp& other)
    : Along(other.Along)
  {
    this->ToPlane->DeepCopy(other.ToPlane);
  }
  rtwWarp& operator=(const rtwWarp& other)
  {
    this->Along = other.Along;
    this->ToPlane->DeepCopy(other.ToPlane);
    return *this;
  }
};

/// Where the ends of a focus lie in another one, along each axis.
std::array<glm::dvec2, 2> rtwEndsIn(const rtwWarp& other, const rtwWarp& of);
/// The greatest of any two values.
double rtwDifference(const rtw::WarpingFunction& a, const rtw::WarpingFunction& b);
double rtwDifference(const rtwWarp& a, const rtwWarp& b);

/// Objects, a sun and a spot, and beside the stage's own pass one that forgets each frame.
class rtwWarpViews : public rtwShadowStage
{
public:
  rtwWarpViews();

  rtwWarp WarpOf(vtkRTWShadowMapPass* pass, int light);
  /// This frame's.
  rtwWarp Follow(int light = 0);
  /// What this frame alone wants.
  rtwWarp Forget(int light = 0);

  vtkRTWShadowMapPass* Following; ///< the stage's
  vtkNew<vtkRTWShadowMapPass> Plain;
  vtkNew<vtkShadowRenderStepsPass> PlainSteps;
  vtkLight* Sun;
  vtkLight* Spot;
  vtkCamera* Camera;
};

#endif
