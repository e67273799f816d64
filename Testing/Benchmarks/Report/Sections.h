// SPDX-License-Identifier: BSD-3-Clause
// The sections of a page on families that run only when they are named. Each is empty where the
// results have nothing of it.
#ifndef Sections_h
#define Sections_h

#include "Results.h"

#include <string>
#include <vector>

/// Tables 1 to 3 of the paper on rectilinear texture warping, beside its own numbers.
std::string PaperSection(const Results& results);

/// Importance functions, ways to draw edges, filters, and sources of view samples. Plots are
/// written into `folder`/`plots`.
std::string VariantSections(
  const Results& results, const std::string& folder, const std::string& plots);

/// What is said of the technique rtw, with whether it is so.
std::string ClaimsSection(const Results& results);
std::string ClaimsTable(const Results& results); // of that section

/// The families that have one.
std::vector<std::string> SectionFamilies();

#endif
