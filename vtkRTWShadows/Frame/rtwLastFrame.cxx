// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwLastFrame.h"

namespace rtw
{
void LastFrame::Capture(const View& view, std::uint64_t signature)
{
  this->Viewed = view;
  this->Depth.Allocate(Format::Depth, view.Width, view.Height);
  this->Signature = this->Depth.CopyFromTarget(view.OriginX, view.OriginY) ? signature : 0;
}

bool LastFrame::Resembles(const View& view, double sceneSize) const
{
  return this->Signature != 0 && rtw::Resembles(view, this->Viewed, sceneSize);
}

void LastFrame::Dispose(Disposal dispose)
{
  dispose(this->Depth);
  this->Forget();
}
}
