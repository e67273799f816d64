// SPDX-License-Identifier: BSD-3-Clause
// What P. Rosen, Rectilinear Texture Warping for Fast Adaptive Shadow Mapping, 2012, measured on a
// GeForce GTX 480 at 1920 x 1080 pixels: all of its tables, in milliseconds.
#ifndef PaperNumbers_h
#define PaperNumbers_h

#include <array>
#include <optional>
#include <string>
#include <vector>

constexpr std::array<const char*, 3> PAPER_SCENES = { "playground", "sandbox", "town" };

/// Frame times along a path.
struct PaperRange
{
  double Least, Most;
  double Middle() const { return (this->Least + this->Most) / 2; }
};

/// A row of table 1, or a column of table 3.
struct PaperTimes
{
  int Table;
  const char* Name;    // in the paper
  const char* Variant; // of the family "paper"
  std::array<PaperRange, 3> Scenes;
};
const std::vector<PaperTimes>& PaperFrameTimes();

/// A column of table 2, of the view of figure 1, which is one of the playground. Stages that there
/// are none of take 0.
struct PaperStages
{
  const char* Name; // in the paper
  const char* Variant;
  const char* Tessellated; // variant; empty for the conventional map
  double ImportanceMap, WarpingMap, ShadowMap, Output, Total; // a to d
  double TessellatedShadowMap, TessellatedTotal;
};
const std::vector<PaperStages>& PaperStageTimes();

/// Of a table's variant, in times of the conventional map's frame; nothing if the paper has none.
/// Ranges stand for their middle. Table 3 has no conventional map, so that table 1's is taken.
std::optional<double> PaperRatio(int table, const std::string& variant, const std::string& scene);

#endif
