// SPDX-License-Identifier: BSD-3-Clause
// Fits each layer to what the camera sees in the light: the desired view, by reduction on the GPU.
#ifndef rtwFocus_h
#define rtwFocus_h

#include "rtwBuffer.h"
#include "rtwLightFrame.h"
#include "rtwProgram.h"

#include <vector>

namespace rtw
{
class ViewSampler;
class WarpTable;

/// How far beyond what the camera sees a filter looks.
struct FilterReach
{
  double World = 0; ///< at the receiver, across the light
  double Share = 0; ///< of the map's side
};

class FocusStage
{
public:
  bool Build();
  const std::string& GetLog() const;
  /// One frame a layer. `also` are rectangles that each layer must hold too: receivers that aren't sampled.
  void Reduce(const std::vector<LightFrame>& frames, const std::vector<Rectangle>& also,
    const ViewSampler& samples, int stride, const FilterReach& filter, const WarpTable& table);
  void Release();
  void Abandon();

private:
  Program Reduction, Writing;
  Buffer Bounds, Tiles;
};
}

#endif
