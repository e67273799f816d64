// SPDX-License-Identifier: BSD-3-Clause
// The lights of a renderer that need a shadow map.
#ifndef rtwLightCollector_h
#define rtwLightCollector_h

#include "Light/rtwLightFrame.h"

#include "vtkLight.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkRenderer;

namespace rtw
{
struct LightCollection
{
  std::vector<ShadowLight> Shadowing;
  /// The lights that need a map, in the order of their numbers: weak, because a light that is gone
  /// is none of them, even where a new one has its address.
  std::vector<vtkWeakPointer<vtkLight>> Sources;
  int Switched = 0;        ///< lights that are on
  /// switched-on lights that are black, or whose shadows weigh nothing or can't be seen
  /// (headlights)
  int Skipped = 0;
  int Unsupported = 0; ///< switched-on point lights, and spots as wide as one
  int Broken = 0;      ///< switched-on lights with a direction or position that is not a number
};

LightCollection CollectLights(vtkRenderer* renderer);

/// A light's number among those that need a map; -1 for null and for any other light.
int FindLight(const LightCollection& lights, vtkLight* light);
}

#endif
