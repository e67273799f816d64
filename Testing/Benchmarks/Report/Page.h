// SPDX-License-Identifier: BSD-3-Clause
// The page of one renderer.
#ifndef Page_h
#define Page_h

#include "Comparison.h"
#include "Results.h"

#include <string>
#include <vector>

/// An earlier run on the same renderer, and what has changed since.
struct Change
{
  std::string File;
  Comparison Found;
};

/// All tables and plots of a run, as Markdown; plots are written into `folder`/`plots`.
std::string WritePage(const Results& results, const std::vector<Change>& changes,
  const std::string& folder, const std::string& plots);

/// A few lines on a run, for the index: error and time of each technique over all scenes.
std::string Summary(const Results& results);

/// In words, for the page and for stdout.
std::string Tell(const Change& change);

#endif
