// SPDX-License-Identifier: BSD-3-Clause
// What the viewer sees through: the camera of a renderer, in double precision.
#ifndef rtwView_h
#define rtwView_h

#include <glm/glm.hpp>

class vtkMatrix4x4;
class vtkRenderState;
class vtkRenderer;

namespace rtw
{
struct View
{
  glm::dmat4 WorldToView{ 1 };
  glm::dmat4 ViewToWorld{ 1 };
  glm::dmat4 ViewToClip{ 1 };
  glm::dmat4 ClipToView{ 1 };
  glm::dvec3 Eye{ 0 };     ///< in world coordinates
  glm::dvec3 Forward{ 0 }; ///< unit
  bool Parallel = false;
  int OriginX = 0; ///< of the viewport in what is drawn into, in pixels
  int OriginY = 0;
  int Width = 0;
  int Height = 0;

  /// Where the eye is in view coordinates: beside their origin, in stereo. In a parallel view the way towards it, one
  /// unit of distance long.
  glm::dvec3 SeenFrom() const;
  bool IsUsable() const; ///< false for an empty viewport or a camera that is not a number
};

/// Whether a view shows about what another did: it is of the same size and place, and the camera
/// has only moved on. Lengths are beside the scene's diagonal.
bool Resembles(const View& view, const View& other, double sceneSize);

/// VTK's row-major matrix as GLM's.
glm::dmat4 ToGlm(vtkMatrix4x4* matrix);
/// Lets a renderer's camera know whether its window draws in stereo, as only VTK's own way to draw does, but no
/// vtkCameraPass. To be called before anything asks the camera for its projection.
void FollowStereo(vtkRenderer* renderer);
/// Whether that camera now stands for the second eye of a pair.
bool IsRightEye(vtkRenderer* renderer);
/// Of the frame that a render state is for, in the viewport that is set.
View ViewOf(const vtkRenderState* state);
}

#endif
