// SPDX-License-Identifier: BSD-3-Clause
// What settings of techniques are called on command lines and in results.
#ifndef rtwTechniqueNames_h
#define rtwTechniqueNames_h

#include "rtwTechnique.h"

#include <string>
#include <utility>
#include <vector>

namespace rtw
{
template <class Value>
using Names = std::vector<std::pair<std::string, Value>>;

const Names<Filter>& FilterNames();
const Names<Rasterization>& RasterizationNames();
const Names<SampleSource>& SampleSourceNames();
const Names<LightPlaneTurn>& LightPlaneTurnNames();
const Names<Splits>& SplitsNames();
const Names<LayerWarp>& LayerWarpNames();
const Names<DepthTest>& DepthTestNames();
const Names<Perspective>& PerspectiveNames();
const Names<Analysis>& AnalysisNames();
const Names<Importance>& ImportanceNames();

/// Importance functions with a plus between them, where "published" stands for the first three.
/// Throws UsageError, which names the option, for any other text.
std::vector<Importance> ReadImportance(const std::string& option, const std::string& text);
/// psm, lispsm, tsm, none, or n' itself.
void ReadPerspective(
  const std::string& option, const std::string& text, TechniqueSettings& settings);
/// square, critical, automatic, or a ratio.
void ReadResolutionSplit(
  const std::string& option, const std::string& text, TechniqueSettings& settings);
}

#endif
