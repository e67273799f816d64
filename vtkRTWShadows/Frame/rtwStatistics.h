// SPDX-License-Identifier: BSD-3-Clause
// What the last frame did and what it could leave out.
#ifndef rtwStatistics_h
#define rtwStatistics_h

#include <cstdint>

namespace rtw
{
struct Statistics
{
  int Lights = 0;        ///< lights with a shadow map
  int LightsSkipped = 0; ///< lights that are on and need no shadow map
  int LayersDrawn = 0;
  int LayersReused = 0;          ///< layers kept because nothing that they depend on changed
  std::int64_t ShadowMemory = 0; ///< bytes of maps, tables and view samples
};
}

#endif
