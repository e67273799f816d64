// SPDX-License-Identifier: BSD-3-Clause
// Tables with a row for each variant of a technique.
#ifndef VariantTable_h
#define VariantTable_h

#include "Results.h"

#include <functional>
#include <string>
#include <vector>

struct VariantColumn
{
  std::string Title;
  std::function<std::string(const Line& line)> Print;
};

/// What a row is called: the variant, or the technique where there are none.
std::string VariantName(const Line& line);

/// Of each scene these columns, "-" where a line is missing; before them what is said of any of a
/// variant's lines.
std::string VariantTable(const Selection& lines, const std::string& corner,
  const std::vector<VariantColumn>& columns, const std::vector<VariantColumn>& overall = {});

/// In times of another line on the same setup, by what both take in times of VTK's pass.
double TimeRatio(const Line& line, const Line& base);

/// Milliseconds of several of the GPU's stages.
double StageSum(const Line& line, const std::vector<std::string>& stages);

#endif
