// SPDX-License-Identifier: BSD-3-Clause
#include "VariantTable.h"

#include "Markdown.h"

#include <algorithm>
#include <numeric>

std::string VariantName(const Line& line)
{
  const std::string variant = line.Key("variant");
  return variant.empty() ? line.Key("technique") : variant;
}

std::string VariantTable(const Selection& lines, const std::string& corner,
  const std::vector<VariantColumn>& columns, const std::vector<VariantColumn>& overall)
{
  const std::vector<std::string> scenes = ValuesOf(lines, "scene");
  std::vector<std::string> header = { corner };
  for (const VariantColumn& column : overall)
  {
    header.push_back(column.Title);
  }
  for (const std::string& scene : scenes)
  {
    for (const VariantColumn& column : columns)
    {
      header.push_back(scene + " " + column.Title);
    }
  }
  MarkdownTable table(header);
  std::vector<std::string> done = { "none" };
  for (const Line* first : lines)
  {
    const std::string name = VariantName(*first);
    if (std::find(done.begin(), done.end(), name) != done.end())
    {
      continue;
    }
    done.push_back(name);
    std::vector<std::string> row = { name };
    for (const VariantColumn& column : overall)
    {
      row.push_back(column.Print(*first));
    }
    for (const std::string& scene : scenes)
    {
      const auto line = std::find_if(lines.begin(), lines.end(), [&](const Line* each) {
        return VariantName(*each) == name && each->Key("scene") == scene;
      });
      for (const VariantColumn& column : columns)
      {
        row.push_back(line == lines.end() ? "-" : column.Print(**line));
      }
    }
    table.Add(row);
  }
  return table.Text();
}

double TimeRatio(const Line& line, const Line& base)
{
  const double divisor = base.Value("to_vtk");
  return divisor > 0 ? line.Value("to_vtk") / divisor : 0;
}

double StageSum(const Line& line, const std::vector<std::string>& stages)
{
  return std::accumulate(stages.begin(), stages.end(), 0.0,
    [&](double sum, const std::string& stage) { return sum + line.Value("gpu_ms:" + stage); });
}
