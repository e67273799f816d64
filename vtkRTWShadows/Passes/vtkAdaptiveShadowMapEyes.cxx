// SPDX-License-Identifier: BSD-3-Clause
// The two eyes of vtkAdaptiveShadowMapPass in stereo.
#include "vtkAdaptiveShadowMapPass.h"

#include "Passes/rtwAdaptiveShadowMapInternals.h"

#include <utility>

vtkAdaptiveShadowMapPass::Internals::Internals(const Internals* left)
  : rtw::Warnings(*left)
  , RightEye(true)
  , Pipeline(&left->Pipeline)
  , Options(left->Options)
  , DefaultSequence(left->DefaultSequence)
{
}

void vtkAdaptiveShadowMapPass::UseEye(bool right)
{
  if (right == this->Shadows->RightEye)
  {
    return;
  }
  if (!this->OtherEye)
  {
    this->OtherEye = std::make_unique<Internals>(this->Shadows.get());
  }
  std::swap(this->Shadows, this->OtherEye);
  rtw::Warnings& warned = *this->Shadows;
  warned = *this->OtherEye;
}

void vtkAdaptiveShadowMapPass::UseEye(vtkRenderer* renderer)
{
  rtw::FollowStereo(renderer);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->OtherEye && window)
  {
    const bool same = this->Shadows->Pipeline.IsOf(window) && this->OtherEye->Pipeline.IsOf(window);
    if (!window->GetStereoRender() || !same)
    {
      this->DropRightEye(same ? window : nullptr);
    }
  }
  const bool right = rtw::IsRightEye(renderer);
  if (right && window && !this->Shadows->RightEye)
  {
    // Which has what both share, though only the right eye may ever be drawn.
    this->Shadows->Pipeline.SetContext(window);
  }
  this->UseEye(right);
}

// Drops the right eye, whose resources are in the window's context; null for a window that is gone.
void vtkAdaptiveShadowMapPass::DropRightEye(vtkWindow* w)
{
  this->UseEye(false);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(w);
  if (this->OtherEye && window)
  {
    this->OtherEye->Pipeline.Release(window);
  }
  this->OtherEye = nullptr;
}
