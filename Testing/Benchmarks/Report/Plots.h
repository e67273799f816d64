// SPDX-License-Identifier: BSD-3-Clause
// Which charts a run gives.
#ifndef Plots_h
#define Plots_h

#include "Chart.h"
#include "Results.h"

#include <string>
#include <utility>
#include <vector>

/// Memory, in MiB, at which techniques are marked beside each other.
extern const std::vector<double> EQUAL_MEMORY;

/// A point of a technique's curve where its maps take that much memory, between the nearest two
/// resolutions: milliseconds and wrong %. Empty where no resolution takes as much, or as little.
std::vector<double> AtMemory(const Selection& maps, double mebibytes);

/// Of a scene of the family maps, by one technique, from small maps to large ones.
Selection MapsOf(const Results& results, const std::string& scene, const std::string& technique);

/// Error against milliseconds, a curve a technique, along the resolutions.
Chart ErrorChart(const Results& results, const std::string& scene);

/// The families in which a number grows, with that number's name in words.
std::vector<std::pair<std::string, std::string>> GrowthFamilies();

/// A technique's milliseconds over what grows; of the window, over its pixels.
Curve GrowthCurve(const Results& results, const std::string& family, const std::string& technique);
/// Of importance functions in a scene: error against milliseconds, a colour an analysis.
Chart FunctionChart(const Selection& lines, const std::string& scene);

Chart GrowthChart(const Results& results, const std::string& family, const std::string& what);

#endif
