// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"

#include "Markdown.h"
#include "PaperNumbers.h"
#include "VariantTable.h"

#include <algorithm>

namespace
{
using Strings = std::vector<std::string>;

const char INTRODUCTION[] =
  "P. Rosen, *Rectilinear Texture Warping for Fast Adaptive Shadow Mapping*, 2012: its tables, "
  "with "
  "times in times of the conventional map's frame (*×*), here and in the *paper*, whose ranges "
  "stand for their middle. The conventional map is a uniform one of the whole scene; importance is "
  "what the paper describes, with shadow edges where there is a light's image; scenes are those "
  "that bear its scenes' names; wrong % is against exact rays.\n\n";

const char STAGES[] =
  "Stages of the GPU: *(a)* is drawing view samples and light's images, and the focus; *(b)* "
  "collecting importance, which is a part of the paper's (a), and the warping maps; *(c)* the "
  "light pass; *(d)* what is left of the frame, the mask among it, and of the conventional map, "
  "whose view samples serve the mask alone, those too. × is in times of the conventional map's "
  "whole frame.\n\n";

std::string Ratio(const std::optional<double>& value)
{
  return value ? Times(*value) : "-";
}

const Line* Conventional(const Selection& lines, const std::string& scene)
{
  return Pick(lines, { { "scene", scene }, { "variant", "conventional" } });
}

// Two cells: what is measured, and the paper's ratio.
void AddCells(const Selection& lines, int table, const std::string& variant,
  const std::string& scene, Strings& row)
{
  const Line* line = Pick(lines, { { "scene", scene }, { "variant", variant } });
  const Line* base = Conventional(lines, scene);
  row.push_back(line && base ? Percent(line->Value("wrong_percent")) + " · " +
        Milliseconds(line->Value("ms")) + " · " + Times(TimeRatio(*line, *base))
                             : "-");
  row.push_back(Ratio(PaperRatio(table, variant, scene)));
}

std::string Table1(const Selection& lines)
{
  Strings header = { "" };
  for (const char* scene : PAPER_SCENES)
  {
    header.push_back(scene + std::string(" wrong % · ms · ×"));
    header.push_back("paper ×");
  }
  MarkdownTable table(header);
  for (const PaperTimes& times : PaperFrameTimes())
  {
    if (times.Table == 1)
    {
      Strings row = { times.Name };
      for (const char* scene : PAPER_SCENES)
      {
        AddCells(lines, 1, times.Variant, scene, row);
      }
      table.Add(row);
    }
  }
  return "### Table 1: frames\n\nTessellated to 2.5 % of the map's side.\n\n" + table.Text();
}

struct Stages
{
  double ImportanceMap = 0, WarpingMap = 0, ShadowMap = 0, Output = 0, Total = 0;
};

Stages StagesOf(const Line& line)
{
  Stages s;
  s.Total = line.Value("gpu_ms");
  s.ShadowMap = StageSum(line, { "geometry", "light pass" });
  if (line.Key("technique") != "uniform")
  {
    s.ImportanceMap = StageSum(line, { "view samples", "resampling", "focus", "light images" });
    s.WarpingMap = StageSum(line, { "warp" });
  }
  // Medians of noisy frames need not add up.
  s.Output = std::max(s.Total - s.ImportanceMap - s.WarpingMap - s.ShadowMap, 0.0);
  return s;
}

std::string Table2(const Selection& lines)
{
  const auto& columns = PaperStageTimes();
  const std::string scene = PAPER_SCENES.front();
  const Line* base = Conventional(lines, scene);
  if (!base)
  {
    return "";
  }
  struct Row
  {
    const char* Name;
    bool IsTessellated;
    double Stages::*Own;
    double PaperStages::*Paper;
  };
  const Row rows[] = { { "(a) Importance Map Calculation", false, &Stages::ImportanceMap,
                         &PaperStages::ImportanceMap },
    { "(b) Warping Map Calculation", false, &Stages::WarpingMap, &PaperStages::WarpingMap },
    { "(c) Shadow Map Rendering", false, &Stages::ShadowMap, &PaperStages::ShadowMap },
    { "(w/ tessellation)", true, &Stages::ShadowMap, &PaperStages::TessellatedShadowMap },
    { "(d) Output rendering or compositing", false, &Stages::Output, &PaperStages::Output },
    { "Total", false, &Stages::Total, &PaperStages::Total },
    { "(w/ tessellation)", true, &Stages::Total, &PaperStages::TessellatedTotal } };
  Strings header = { scene };
  for (const PaperStages& column : columns)
  {
    header.push_back(column.Name + std::string(" ms · ×"));
    header.push_back("paper ×");
  }
  MarkdownTable table(header);
  for (const Row& row : rows)
  {
    Strings cells = { row.Name };
    for (const PaperStages& column : columns)
    {
      const std::string variant = row.IsTessellated ? column.Tessellated : column.Variant;
      const Line* line =
        variant.empty() ? nullptr : Pick(lines, { { "scene", scene }, { "variant", variant } });
      const double own = line ? StagesOf(*line).*row.Own : 0;
      const double paper = column.*row.Paper;
      const bool isMeasured = line && (own > 0 || row.Own == &Stages::Output);
      cells.push_back(isMeasured
          ? Milliseconds(own) + " · " + Times(own / base->Value("gpu_ms"))
          : "-");
      cells.push_back(paper > 0 ? Times(paper / columns.front().Total) : "-");
    }
    table.Add(cells);
  }
  return "### Table 2: stages\n\n" + std::string(STAGES) + table.Text();
}

std::string Table3(const Selection& lines, const std::string& analysis)
{
  Strings header = { analysis };
  for (const PaperTimes& times : PaperFrameTimes())
  {
    if (times.Table == 3)
    {
      header.push_back(times.Name + std::string(" wrong % · ms · ×"));
      header.push_back("paper ×");
    }
  }
  MarkdownTable table(header);
  for (const char* scene : PAPER_SCENES)
  {
    Strings row = { scene };
    for (const PaperTimes& times : PaperFrameTimes())
    {
      if (times.Table == 3)
      {
        const std::string backward = times.Variant;
        AddCells(lines, 3, analysis + backward.substr(backward.find('+')), scene, row);
      }
    }
    table.Add(row);
  }
  return table.Text();
}
}

std::string PaperSection(const Results& results)
{
  const Selection all = OfFamily(results, "paper");
  std::string text = all.empty() ? "" : std::string("## The paper's tables\n\n") + INTRODUCTION;
  for (const std::string& map : ValuesOf(all, "map"))
  {
    const Selection lines = Select(all, "map", map);
    text += "Maps have " + map + " × " + map + " texels.\n\n" + Table1(lines) + Table2(lines) +
      "### Table 3: tessellation\n\nThe paper's are of the backward analysis.\n\n" +
      Table3(lines, "backward") + Table3(lines, "forward") + Table3(lines, "hybrid");
  }
  return text;
}
