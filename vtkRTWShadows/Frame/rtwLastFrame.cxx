// SPDX-License-Identifier: BSD-3-Clause
#include "rtwLastFrame.h"

#include <cmath>

namespace rtw
{
namespace
{
// What the focus' margin makes up for.
constexpr double FarthestMove = 0.01; // of the scene's diagonal
constexpr double LargestTurn = 3;     // degrees
constexpr double LargestZoom = 1.05;

bool IsAbout(double a, double b)
{
  const double ratio = a / b;
  return ratio <= LargestZoom && ratio >= 1 / LargestZoom;
}
}

void LastFrame::Capture(const View& view, std::uint64_t signature)
{
  this->Viewed = view;
  this->Depth.Allocate(Format::Depth, view.Width, view.Height);
  this->Signature = this->Depth.CopyFromTarget(view.OriginX, view.OriginY) ? signature : 0;
}

bool LastFrame::Resembles(const View& view, double sceneSize) const
{
  const View& was = this->Viewed;
  const double turn = std::cos(glm::radians(LargestTurn));
  const glm::dvec3 up(view.ViewToWorld[1]), wasUp(was.ViewToWorld[1]);
  return this->Signature != 0 && view.Parallel == was.Parallel && view.Width == was.Width &&
    view.Height == was.Height && glm::distance(view.Eye, was.Eye) <= FarthestMove * sceneSize &&
    glm::dot(view.Forward, was.Forward) >= turn && glm::dot(up, wasUp) >= turn &&
    IsAbout(view.ViewToClip[0][0], was.ViewToClip[0][0]) &&
    IsAbout(view.ViewToClip[1][1], was.ViewToClip[1][1]);
}

void LastFrame::Release()
{
  this->Depth.Release();
  this->Forget();
}

void LastFrame::Abandon()
{
  this->Depth.Abandon();
  this->Forget();
}
}
