// SPDX-License-Identifier: BSD-3-Clause
// The numbers behind figures 5, 6, 7, 10, 12 and 13 of Lloyd et al. 2006, as comma-separated
// values.
#ifndef Figures_h
#define Figures_h

#include "Partition/rtwStorageFactor.h"

#include <string>
#include <vector>

struct Scheme
{
  std::string Name; ///< as the paper abbreviates it: ZP, FP, W
  rtw::StorageScheme Of;
};

/// Without and with warping and faces, of so many depth partitions.
std::vector<Scheme> Schemes(int partitions);

/// Throws rtw::UsageError for a figure that has no numbers.
std::string FigureText(int figure, const rtw::StoredView& view);

/// All schemes of 1 to so many depth partitions, for a light overhead, one behind, and the
/// direction above the horizon that has the most: closed forms beside numbers.
std::string TableText(const rtw::StoredView& view, int partitions);

/// For a light of one direction, in a view along -z with y up.
std::string LightText(const rtw::StoredView& view, int partitions, const glm::dvec3& direction);

#endif
