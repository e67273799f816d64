// SPDX-License-Identifier: BSD-3-Clause
// What the viewer sees through: the camera of a renderer, in double precision.
//
// View coordinates, which become floats on the GPU, begin at the eye where that is among what is seen. Where it is far from that, or a
// parallel camera's, of which nothing is seen, they begin just before what is seen: such a view is framed.
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
  glm::dvec3 Origin{ 0 }; ///< origin of view coordinates, in world coordinates
  /// Place of the eye in world coordinates; in a parallel view that is framed, the origin.
  glm::dvec3 Eye{ 0 };
  glm::dvec3 Forward{ 0 }; ///< unit
  bool Parallel = false;
  bool Framed = false;
  double Begin = 0;        ///< distance of the origin from the camera along the view
  glm::dvec2 Range{ 0 };   ///< distances of the near and the far plane of a framed view from the camera
  /// Row of the camera's own projection, which the picture's depth follows.
  glm::dvec2 DepthRow{ 0 };
  int OriginX = 0; ///< left end of the viewport in the target, in pixels
  int OriginY = 0;
  int Width = 0;
  int Height = 0;

  bool IsUsable() const; ///< false for an empty viewport or a camera that is not a number
  /// How far the origin is from an eye.
  double BeyondEye() const { return this->Parallel ? 0 : this->Begin; }
};

/// Whether a view shows about what another did: it is of the same size and place, and the camera
/// has only moved on. Lengths are beside the scene's diagonal. What counts is the place from where
/// view coordinates go.
bool Resembles(const View& view, const View& other, double sceneSize);

/// VTK's row-major matrix as GLM's.
glm::dmat4 ToGlm(vtkMatrix4x4* matrix);
void FromGlm(const glm::dmat4& from, vtkMatrix4x4* to);
/// Lets a renderer's camera know whether its window draws in stereo, as only VTK's own way to draw does, but no
/// vtkCameraPass. To be called before anything asks the camera for its projection.
void FollowStereo(vtkRenderer* renderer);
/// Whether that camera now stands for the second eye of a pair.
bool IsRightEye(vtkRenderer* renderer);
/// The view of the frame that a render state is for, in the viewport that is set.
View ViewOf(const vtkRenderState* state);
}

#endif
