// SPDX-License-Identifier: BSD-3-Clause
// The lights of a renderer that need a shadow map.
#ifndef rtwLightCollector_h
#define rtwLightCollector_h

#include "rtwLightFrame.h"

#include <vector>

class vtkRenderer;

namespace rtw
{
struct LightCollection
{
  std::vector<ShadowLight> Shadowing;
  int Switched = 0;        ///< lights that are on
  int Skipped = 0;         ///< of those: black, or their shadows weigh nothing, or can't be seen (headlights)
  int Unsupported = 0;     ///< of those: point lights and spots as wide as one
  int Broken = 0;          ///< of those: with a direction or position that is not a number
};

LightCollection CollectLights(vtkRenderer* renderer);
}

#endif
