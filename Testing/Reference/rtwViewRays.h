// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwViewRays_h
#define rtwViewRays_h

#include "rtwGeometry.h"

class vtkCamera;

namespace rtw
{
/// In world coordinates, as the camera's own matrix has it.
dvec3 EyePosition(vtkCamera* camera);

/// The rays of a camera's picture, by its own matrices: perspective, parallel or explicit ones, off
/// centre, and for windows of any shape. They reach from the near plane to the far one.
class ViewRays
{
public:
  ViewRays(vtkCamera* camera, int width, int height);

  /// In pixels, from the lower left corner of the picture. Relative to the camera's position.
  Ray At(double x, double y) const;

  /// As a depth buffer has it, of a position relative to the camera's.
  double WindowDepth(const dvec3& position) const;

private:
  int Width;
  int Height;
  glm::dmat3 ToWorld; // directions, from eye coordinates
  glm::dmat3 ToEye;
  glm::dmat4 Projection;
  glm::dmat4 Unprojection;
  bool HasCentre; // all rays meet in the camera's position
};
}

#endif
