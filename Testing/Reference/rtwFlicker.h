// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwFlicker_h
#define rtwFlicker_h

#include "rtwReference.h"

#include <cstddef>
#include <vector>

namespace rtw
{
/// How much a mask flickers along a path of small moves: pixels whose decision changes from one
/// frame to the next though the truth stays lit or stays in shadow.
class Flicker
{
public:
  /// One after another. Mask values are as for Compare(); a pixel without a decision in one of two
  /// frames does not flicker between them. A frame of another size starts anew.
  /// Throws std::invalid_argument if the mask's size is not the truth's.
  void Add(const std::vector<unsigned char>& mask, const Truth& truth);

  /// The next frame does not follow the one before.
  void StartAnew() { this->LastMask.clear(); }

  /// Of each step from frame to frame: the share, in percent, of the pixels whose truth stays.
  const std::vector<double>& Percents() const { return this->Steps; }
  /// 0 before there are two frames.
  double MeanPercent() const;
  double GreatestPercent() const;

private:
  std::vector<unsigned char> LastMask;
  std::vector<unsigned char> LastTruth;
  int LastWidth = 0;
  std::vector<double> Steps;
};
}

#endif
