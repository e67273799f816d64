// SPDX-License-Identifier: BSD-3-Clause
// How a shadow's edge goes from dark to lit along a line of pixels.
#ifndef rtwShadowProfile_h
#define rtwShadowProfile_h

#include "rtwShadowStage.h"

#include <vector>

/// The share of light that is left, from the mask of the first light, where a world line is seen:
/// `count` places, evenly spread from one point to another on a surface.
std::vector<double> rtwProfile(
  rtwShadowStage& stage, const double from[3], const double to[3], int count);

/// Whether it rises, and only rises, but for a mask's rounding.
bool rtwIsMonotone(const std::vector<double>& profile);
/// The steepest step from one place to the next.
double rtwSteepest(const std::vector<double>& profile);
/// Where it first comes to a level, as a share of its length, between places; -1 where it never
/// does.
double rtwWhere(const std::vector<double>& profile, double level);
/// From a tenth to nine tenths of the light, as a share of its length.
double rtwWidth(const std::vector<double>& profile);
/// The mean of all decisions of a mask, 0 to 1.
double rtwMeanVisibility(const std::vector<unsigned char>& mask);
/// 0 to 1 from a byte of a mask.
double rtwVisibilityOf(unsigned char value);

#endif
