// SPDX-License-Identifier: BSD-3-Clause
// A light's map as programs of ours look at it: debug views, the predicted error, the choice of a map's sides.
#ifndef rtwMapOfLight_h
#define rtwMapOfLight_h

#include "Light/rtwLightFrame.h"

namespace rtw
{
class LayerTable;
class Program;
class ViewSampler;

/// The map that is looked at, and from where.
struct MapOfLight
{
  const LightFrame& Frame; ///< of its first layer
  int OtherLayers;         ///< how far behind a layer that of its other casters lies; 0 for none
  const ViewSampler& Samples;
  const LayerTable& Table;

  /// Uses a program of ours that looks at it.
  void Use(const Program& program) const;
};

}

#endif
