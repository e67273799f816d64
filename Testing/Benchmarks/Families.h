// SPDX-License-Identifier: BSD-3-Clause
// The families of setups that run only when they are named, and how a setup begins.
#ifndef Families_h
#define Families_h

#include "Setup.h"

#include <string>
#include <vector>

using Setups = std::vector<Setup>;

Setup StartSetup(const char* family, const Options& options);

/// Scenes or resolutions: those that are asked for, or else the family's own, or a few if quick.
template <class Value>
std::vector<Value> Chosen(const Options& options, const std::vector<Value>& asked,
  std::vector<Value> all, std::vector<Value> quick)
{
  return !asked.empty() ? asked : options.Quick ? quick : all;
}

/// Tables 1 to 3 of the paper on rectilinear texture warping.
Setups MakePaper(const Options& options);
/// Every analysis with every importance function.
Setups MakeFunctions(const Options& options);
Setups MakeRasterizations(const Options& options);
Setups MakeFilters(const Options& options);
Setups MakeViewSamples(const Options& options);
/// What is said of the technique rtw, beside what it is said to be better than.
Setups MakeClaims(const Options& options);

#endif
