// SPDX-License-Identifier: BSD-3-Clause
// A run against an earlier one on the same machine.
#ifndef Comparison_h
#define Comparison_h

#include "Results.h"

#include <string>
#include <vector>

/// A line that has become worse by more than noise.
struct Flag
{
  std::string Line;
  std::string What; // "slower", "less accurate", ...
  std::string Unit;
  double Before, After;
  double Tolerance; // of After, in its unit, beyond Before
};

struct Comparison
{
  std::vector<Flag> Flags;
  std::size_t Compared = 0;    // lines that both have, measured alike
  std::size_t WithPixels = 0;  // of those, with pixels compared
  std::size_t EqualPixels = 0; // of those, with exactly as many wrong ones
  double LargestTimeRatio = 1; // of the ratios to VTK's pass, either way
  double MiddleTimeRatio = 1;
  std::vector<std::string> Unlike;  // lines that were measured otherwise, so cannot be compared
  std::vector<std::string> Missing; // lines that the later run has not
};

Comparison Compare(const Results& before, const Results& after);

#endif
