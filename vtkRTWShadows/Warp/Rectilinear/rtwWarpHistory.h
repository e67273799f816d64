// SPDX-License-Identifier: BSD-3-Clause
// What a rectilinear warp remembers of the last frame: its focus, and its warping functions.
#ifndef rtwWarpHistory_h
#define rtwWarpHistory_h

#include "Frame/rtwView.h"
#include "GL/rtwBuffer.h"
#include "GL/rtwResources.h"
#include "Warp/rtwWarpStage.h"

#include <vector>

namespace rtw
{
class WarpHistory
{
public:
  /// Compares a frame with the last one, and becomes it. What was remembered of a layer is void
  /// where its light has moved, and of all where the view was cut, resized or set up otherwise.
  void Follow(const WarpFrame& frame, int cells);
  /// How many frames in a row, the last among them, have been the same.
  int GetStillFrames() const { return this->Still; }
  void BindStorage() const;
  void Dispose(Disposal dispose);

private:
  Buffer Functions;
  std::vector<LightFrame> Frames; ///< none before the first
  View Viewed;
  std::uint64_t Settings = 0;
  int Cells = 0;
  int Still = 0;
};

/// By how much light-plane coordinates differ between two frames of a light; false where the light
/// has moved, so that they differ by more.
bool FindShift(const LightFrame& from, const LightFrame& to, glm::dvec2& shift);
}

#endif
