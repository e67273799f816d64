// SPDX-License-Identifier: BSD-3-Clause
// What a frame has for an analysis to look at.
#ifndef rtwAnalysisInput_h
#define rtwAnalysisInput_h

#include "Frame/rtwView.h"
#include "Light/rtwLightFrame.h"

#include <vector>

namespace rtw
{
class DenseLayers;
class LayerBlocks;
class Texture;
class ViewSampler;

struct AnalysisInput
{
  const ViewSampler& Samples;
  const LayerBlocks& Blocks;
  int Stride = 1;       ///< every how many pixels there is a sample
  double SceneSize = 0; ///< its diagonal
  const DenseLayers* LightImages =
    nullptr; ///< a layer a light, unwarped, of the size that was asked for; none if none was
  const Texture* LastMask =
    nullptr;     ///< of the last frame, a layer a light; none where there was none
  View LastView; ///< that mask's
  bool AreAll = false; ///< whether no receiver in view is missing from samples and Unsampled
  /// On each light plane, of other receivers and what a filter sees from there.
  std::vector<Rectangle> Unsampled;
  double FilterWorld = 0;  ///< how far a filter looks, in world units,
  double FilterTexels = 0; ///< and on the map, a texel's neighbours aside
  double Straight = 0;     ///< how long a bent edge is drawn straight, of the map's side
};
}

#endif
