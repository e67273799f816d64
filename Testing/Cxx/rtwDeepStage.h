// SPDX-License-Identifier: BSD-3-Clause
// What tests of bent and of large triangles look at.
#ifndef rtwDeepStage_h
#define rtwDeepStage_h

#include "rtwShadowStage.h"

/// Boxes on a floor of so many by so many squares, from far behind the viewer to the horizon, under
/// a sun; with a large roof over some of them, if asked for.
struct rtwDeepStage : rtwShadowStage
{
  rtwDeepStage(rtwTechnique technique, int floorCells, bool roof = false);
  /// A frame's errors; says them.
  rtw::ShadowErrors Compare(const char* name);

  vtkLight* Sun;
  rtw::Truth Truth;
};

#endif
