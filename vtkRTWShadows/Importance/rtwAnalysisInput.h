// SPDX-License-Identifier: BSD-3-Clause
// The data of a frame that an importance analysis looks at.
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
  int Stride = 1;       ///< pixels from one sample to the next along both axes
  double SceneSize = 0; ///< its diagonal
  /// Depth images from the lights, unwarped, one for each map layer; null if none were asked for.
  const DenseLayers* LightImages = nullptr;
  /// The shadow mask of the last frame, a layer for each light; null if there is none.
  const Texture* LastMask = nullptr;
  View LastView;       ///< the view that LastMask was drawn for
  bool AreAll = false; ///< whether no receiver in view is missing from samples and Unsampled
  /// For each map layer, bounds on the light plane of receivers without view samples, and of what a
  /// filter reaches from there.
  std::vector<Rectangle> Unsampled;
  double FilterWorld = 0;  ///< how far a filter looks, in world units,
  double FilterTexels = 0; ///< and in texels on the map, a texel's neighbours aside
  /// Length over which a bent edge is drawn straight, as a share of the map's side.
  double Straight = 0;
};
}

#endif
