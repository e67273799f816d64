// SPDX-License-Identifier: BSD-3-Clause
// Fits each layer to what the camera sees in the light: the desired view, by reduction on the GPU.
#ifndef rtwFocus_h
#define rtwFocus_h

#include "rtwBuffer.h"
#include "rtwLightFrame.h"
#include "rtwProgram.h"

#include <string>
#include <vector>

namespace rtw
{
class ViewSampler;
class WarpTable;
struct View;

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
  std::string GetLog() const;
  /// One frame a layer. `also` are rectangles that a light's only layer must hold too: receivers
  /// that aren't sampled. Of several layers each holds what lies in its depths of their boxes,
  /// given by eight corners each.
  void Reduce(const std::vector<LightFrame>& frames, const std::vector<Rectangle>& also,
    const std::vector<glm::dvec3>& boxes, const ViewSampler& samples, int stride,
    const FilterReach& filter, const WarpTable& table);
  void Release();
  void Abandon();

private:
  void AddBoxes(const std::vector<LightFrame>& frames, const std::vector<glm::dvec3>& corners,
    const View& view, const FilterReach& filter, const WarpTable& table);

  Program Reduction, BoxAdding, Writing;
  Buffer Bounds, Tiles, Boxes;
};
}

#endif
