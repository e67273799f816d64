// SPDX-License-Identifier: BSD-3-Clause
// A light's map as programs of ours look at it: debug views, the predicted error, the choice of a
// map's sides.
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
  const LightFrame& Frame; ///< the light's frame for its first layer
  /// How far behind a layer the one of casters that only VTK's mappers draw lies; 0 for none.
  int OtherLayers;
  const ViewSampler& Samples;
  const LayerTable& Table;

  /// Uses a program of ours and gives it all that it needs to look at the map.
  void Use(const Program& program) const;
};

}

#endif
