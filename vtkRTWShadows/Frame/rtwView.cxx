// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwView.h"

#include "Frame/rtwFramedView.h"
#include "GL/rtwOpenGL.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"

#include <cmath>

namespace rtw
{
namespace
{
// The greatest changes of a view between two frames that a margin of the focus makes up for.
constexpr double FarthestMove = 0.01; // of the scene's diagonal
constexpr double LargestTurn = 3;     // degrees
constexpr double LargestZoom = 1.05;

bool IsAbout(double a, double b)
{
  const double ratio = a / b;
  return ratio <= LargestZoom && ratio >= 1 / LargestZoom;
}
}

bool Resembles(const View& view, const View& other, double sceneSize)
{
  const double turn = std::cos(glm::radians(LargestTurn));
  const glm::dvec3 up(view.ViewToWorld[1]), otherUp(other.ViewToWorld[1]);
  return view.Parallel == other.Parallel && view.Width == other.Width &&
    view.Height == other.Height && view.OriginX == other.OriginX && view.OriginY == other.OriginY &&
    view.Framed == other.Framed &&
    glm::distance(view.Origin, other.Origin) <= FarthestMove * sceneSize &&
    (view.BeyondEye() == other.BeyondEye() || IsAbout(view.BeyondEye(), other.BeyondEye())) &&
    glm::dot(view.Forward, other.Forward) >= turn && glm::dot(up, otherUp) >= turn &&
    IsAbout(view.ViewToClip[0][0], other.ViewToClip[0][0]) &&
    IsAbout(view.ViewToClip[1][1], other.ViewToClip[1][1]);
}

glm::dmat4 ToGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

void FromGlm(const glm::dmat4& from, vtkMatrix4x4* to)
{
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      to->SetElement(row, column, from[column][row]);
    }
  }
}

bool View::IsUsable() const
{
  if (this->Width < 1 || this->Height < 1)
  {
    return false;
  }
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      if (!std::isfinite(this->ViewToWorld[column][row]) ||
        !std::isfinite(this->ClipToView[column][row]))
      {
        return false;
      }
    }
  }
  return true;
}

namespace
{
// A camera has no setter of that: VTK's cameras find out where they draw themselves.
class StereoCamera : public vtkCamera
{
public:
  static bool Set(vtkCamera* camera, bool stereo)
  {
    auto& known = camera->*(&StereoCamera::Stereo);
    const bool changed = (known != 0) != stereo;
    known = stereo ? 1 : 0;
    return changed;
  }
};
}

void FollowStereo(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  vtkCamera* camera = renderer->GetActiveCamera();
  if (window && StereoCamera::Set(camera, window->GetStereoRender() != 0))
  {
    // What mappers draw with is kept as long as the camera stands still.
    camera->Modified();
  }
}

bool IsRightEye(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  return window && window->GetStereoRender() && !renderer->GetActiveCamera()->GetLeftEye();
}

View ViewOf(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  View view;
  // A pass around ours may draw the renderer's viewport elsewhere than in the window, and not say so in the state.
  int viewport[4];
  static_cast<vtkOpenGLRenderer*>(renderer)->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  view.OriginX = viewport[0];
  view.OriginY = viewport[1];
  view.Width = viewport[2];
  view.Height = viewport[3];
  view.WorldToView = ToGlm(camera->GetModelViewTransformMatrix());
  view.ViewToWorld = glm::inverse(view.WorldToView);
  view.ViewToClip =
    ToGlm(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  view.ClipToView = glm::inverse(view.ViewToClip);
  view.DepthRow = { view.ViewToClip[2][2], view.ViewToClip[3][2] };
  view.Origin = glm::dvec3(view.ViewToWorld[3]);
  view.Forward = glm::normalize(-glm::dvec3(view.ViewToWorld[2]));
  view.Parallel = camera->GetParallelProjection() != 0;
  view.Eye = glm::dvec3(
    view.ViewToWorld * glm::dvec4(view.Parallel ? glm::dvec3(0) : SeenFrom(view), 1));
  return view;
}
}
