// SPDX-License-Identifier: BSD-3-Clause
// Why pixels of an exact mask are wrong all the same: a rasterizer puts corners on a lattice of
// 1/256 of a pixel, so that a pixel may show another surface than the ray through its centre meets.
#ifndef rtwOtherSurfaces_h
#define rtwOtherSurfaces_h

#include "rtwReference.h"

#include <vector>

class vtkRenderWindow;

/// How many of the wrong pixels do, by the depth that is drawn there.
int rtwCountOtherSurfaces(
  vtkRenderWindow* window, const std::vector<unsigned char>& mask, const rtw::Truth& truth);

#endif
