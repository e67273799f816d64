// SPDX-License-Identifier: BSD-3-Clause
// Why pixels of an exact mask are wrong all the same: a rasterizer puts corners on a lattice of
// 1/256 of a pixel, so that a pixel may show another surface than the ray through its centre meets,
// and surfaces that it shows lie elsewhere by as much.
#ifndef rtwWrongPixels_h
#define rtwWrongPixels_h

#include "rtwReference.h"

#include <vector>

class vtkLight;
class vtkRenderWindow;

/// How many of the wrong pixels show another surface, by the depth that is drawn there.
int rtwCountOtherSurfaces(
  vtkRenderWindow* window, const std::vector<unsigned char>& mask, const rtw::Truth& truth);

/// The wrong pixels, each counted once, as the first of these that it is.
struct rtwWrongPixels
{
  /// Another surface is within a rasterizer's rounding, and the mask is right for that one, or it
  /// faces no light.
  int OtherSurface = 0;
  /// An edge of the shadow is within the rounding of a rasterizer and of floats.
  int AtEdge = 0;
  /// What casts the shadow, or what doesn't, is so near to the surface that it depends on how far
  /// above it the rays of the reference begin: within a tenth of that and eight times as much.
  int NearSurface = 0;
  int Unexplained = 0;

  /// Of the shadow test alone.
  int WrongShadows() const { return this->AtEdge + this->NearSurface + this->Unexplained; }
};

rtwWrongPixels rtwSortWrongPixels(const std::vector<unsigned char>& mask, const rtw::Truth& truth,
  const rtw::ShadowReference& reference, vtkLight* light);

#endif
