// SPDX-License-Identifier: BSD-3-Clause
// The lines of Google Benchmark: one for each setup and technique.
#ifndef Lines_h
#define Lines_h

#include "Options.h"

#include <string>
#include <vector>

/// Registers all lines that the options ask for, and returns their names. VTK's own pass goes with
/// every setup of which there is a line.
std::vector<std::string> RegisterLines(const Options& options);

#endif
