// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwCompare_h
#define rtwCompare_h

#include "rtwReference.h"

#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

class vtkImageData;

namespace rtw
{
/// How far a mask of shadows is from the truth, in pixels that face the light in truth.
struct ShadowErrors
{
  size_t LitFacing = 0; // the truth is lit or in shadow
  size_t Shadowed = 0;  // of those, in shadow
  size_t WronglyDark = 0;
  size_t WronglyLit = 0;
  size_t NotComparable = 0;   // the mask says 128 there: no decision
  size_t FarFromEdge = 0;     // wrong ones more than two pixels from where the truth changes
  size_t DarkFarFromEdge = 0; // of those, wrongly dark
  size_t AtEdge = 0;          // pixels beside one, above or below too, that is otherwise lit

  ShadowErrors& operator+=(const ShadowErrors& other);

  size_t Wrong() const { return this->WronglyDark + this->WronglyLit; }
  size_t LitFarFromEdge() const { return this->FarFromEdge - this->DarkFarFromEdge; }
  size_t NearEdge() const { return this->Wrong() - this->FarFromEdge; }
  size_t DarkNearEdge() const { return this->WronglyDark - this->DarkFarFromEdge; }
  size_t LitNearEdge() const { return this->WronglyLit - this->LitFarFromEdge(); }
  /// A share of the pixels that face the light.
  double Percent(size_t pixels) const
  {
    return this->LitFacing ? 100.0 * double(pixels) / double(this->LitFacing) : 0.0;
  }
};

/// Which pixels lie within that many of an edge of a shadow, along both axes.
std::vector<char> NearEdges(const Truth& truth, int reach);

/// Mask values below 128 say dark, those above lit. The mask has the truth's size and order of
/// rows. Throws std::invalid_argument if its size is another.
ShadowErrors Compare(const std::vector<unsigned char>& mask, const Truth& truth);

/// The truth in shades of grey, wrongly dark pixels in red, wrongly lit ones in orange, and those
/// without a decision in blue.
vtkSmartPointer<vtkImageData> DifferenceImage(
  const std::vector<unsigned char>& mask, const Truth& truth);

/// A mask as a picture of one component, and back. The first component counts.
vtkSmartPointer<vtkImageData> MaskImage(
  const std::vector<unsigned char>& mask, int width, int height);
std::vector<unsigned char> MaskOf(vtkImageData* image);
}

#endif
