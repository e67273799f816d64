// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Rectilinear/rtwWarpHistory.h"

#include <glm/glm.hpp>

namespace rtw
{
namespace
{
constexpr std::size_t Measures = 4; // before the functions, as in rtwLastWarp.glsl
}

bool FindShift(const LightFrame& from, const LightFrame& to, glm::dvec2& shift)
{
  const ShadowLight &was = from.Light, &is = to.Light;
  const bool isSpot = is.Kind == LightKind::Spot;
  if (was.Kind != is.Kind || was.Direction != is.Direction || from.SAxis != to.SAxis ||
    from.TAxis != to.TAxis ||
    (isSpot && (was.Position != is.Position || was.ConeAngle != is.ConeAngle)))
  {
    return false;
  }
  // Light-plane coordinates have their origin at the eye: they are positions across a directional
  // light, and directions in a spot.
  for (int axis = 0; axis < 2; ++axis)
  {
    shift[axis] = isSpot ? to.ConeCentre[axis] - from.ConeCentre[axis]
                         : to.WorldToLight[3][axis] - from.WorldToLight[3][axis];
  }
  return true;
}

void WarpHistory::Follow(const WarpFrame& frame, int cells)
{
  const bool follows = frame.Frames.size() == this->Frames.size() && cells == this->Cells &&
    frame.Settings == this->Settings && Resembles(frame.Viewed, this->Viewed, frame.SceneSize);
  const std::size_t stride = (Measures + std::size_t(2) * (cells + 1)) * sizeof(float);
  this->Functions.Reserve(frame.Frames.size() * 2 * stride);
  for (std::size_t layer = 0; layer < frame.Frames.size(); ++layer)
  {
    glm::dvec2 shift(0);
    const bool known = follows && FindShift(this->Frames[layer], frame.Frames[layer], shift);
    for (int axis = 0; axis < 2; ++axis)
    {
      const float moved[] = { float(shift[axis]), known ? 1.f : 0.f };
      this->Functions.Write((2 * layer + axis) * stride + 2 * sizeof(float), moved, sizeof(moved));
    }
  }
  this->Frames = frame.Frames;
  this->Viewed = frame.Viewed;
  this->Settings = frame.Settings;
  this->Cells = cells;
  this->Still = !frame.Current ? 0 : frame.Still && follows ? this->Still + 1 : 1;
}

void WarpHistory::BindStorage() const
{
  this->Functions.BindStorage(5); // as in rtwLastWarp.glsl
}

void WarpHistory::Dispose(Disposal dispose)
{
  dispose(this->Functions);
  this->Frames.clear();
  this->Still = 0;
}
}
