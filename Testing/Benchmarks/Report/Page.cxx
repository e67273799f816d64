// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include "Markdown.h"
#include "Plots.h"
#include "Sections.h"

#include "rtwQuantile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
const char USUAL_MAP[] = "1024";

std::string Image(const std::string& title, const std::string& plots, const std::string& name)
{
  return "![" + title + "](" + plots + "/" + name + ".png)\n\n";
}

std::string Machine(const Results& results)
{
  MarkdownTable table({ "", "" });
  const auto add = [&](const char* what, const char* key) {
    const auto at = results.Context.find(key);
    table.Add({ what, at == results.Context.end() ? "unknown" : at->second });
  };
  add("OpenGL renderer", "gl_renderer");
  add("OpenGL version", "gl_version");
  add("VTK", "vtk_version");
  add("build", "build_type");
  table.Add({ "processor cores", std::to_string(results.Cores) });
  table.Add({ "date", results.Date });
  const auto fault = results.Context.find("fault");
  if (fault != results.Context.end() && fault->second != "none")
  {
    table.Add({ "fault made on purpose", fault->second });
  }
  return table.Text();
}

std::string NoiseText(const Results& results)
{
  std::vector<double> noise;
  for (const Line& line : results.Lines)
  {
    if (line.Key("technique") != "vtk" && line.Key("technique") != "none")
    {
      noise.push_back(100 * line.Noise("to_vtk"));
    }
  }
  char text[256];
  std::snprintf(text, sizeof text,
    "Noise: from lap to lap, a ratio to VTK's pass has a standard deviation of %.1f %% in the "
    "middle "
    "of all lines and %.1f %% at the 95th percentile.\n\n",
    rtw::Median(noise), rtw::Quantile(noise, 0.95));
  return text;
}

// Scenes in rows, techniques in columns, at the usual map.
std::string Overview(const Results& results)
{
  const Selection maps = OfFamily(results, "maps");
  const std::vector<std::string> techniques = ValuesOf(maps, "technique");
  std::vector<std::string> header = { "scene" };
  for (const std::string& technique : techniques)
  {
    header.push_back(technique + (technique == "none" ? " ms" : " wrong % · × vtk"));
  }
  MarkdownTable table(header);
  for (const std::string& scene : ValuesOf(maps, "scene"))
  {
    std::vector<std::string> row = { scene };
    for (const std::string& technique : techniques)
    {
      const Line* line =
        Pick(maps, { { "scene", scene }, { "technique", technique }, { "map", USUAL_MAP } });
      row.push_back(!line ? "-"
          : technique == "none"
          ? Milliseconds(line->Value("ms"))
          : Percent(line->Value("wrong_percent")) + " · " + Times(line->Value("to_vtk")));
    }
    table.Add(row);
  }
  return "### At 1024 × 1024 texels\n\n" + table.Text();
}

struct Column
{
  const char* Title;
  const char* Counter;
  std::string (*Print)(double value);
};

const Column COLUMNS[] = { { "wrong %", "wrong_percent", Percent },
  { "dark %", "wrongly_dark_percent", Percent }, { "lit %", "wrongly_lit_percent", Percent },
  { "far %", "far_percent", Percent }, { "flicker %", "flicker_percent", Percent },
  { "aliasing 95 %", "aliasing_p95", Times }, { "ms", "ms", Milliseconds },
  { "95 % ms", "p95_ms", Milliseconds }, { "× vtk", "to_vtk", Times },
  { "CPU ms", "cpu_ms", Milliseconds }, { "GPU ms", "gpu_ms", Milliseconds },
  { "MiB", "memory_bytes", Mebibytes } };

std::vector<std::string> Row(const Line& line)
{
  const std::string technique = line.Key("technique");
  std::vector<std::string> row = { technique, technique == "none" ? "" : line.Key("map") };
  for (const Column& column : COLUMNS)
  {
    row.push_back(line.Has(column.Counter) ? column.Print(line.Value(column.Counter)) : "");
  }
  return row;
}

MarkdownTable LineTable(const char* first)
{
  std::vector<std::string> header = { first, "map" };
  for (const Column& column : COLUMNS)
  {
    header.push_back(column.Title);
  }
  return MarkdownTable(header);
}

std::string EqualMemory(const Results& results, const std::string& scene)
{
  const std::vector<std::string> techniques = ValuesOf(OfFamily(results, "maps"), "technique");
  std::vector<std::string> header = { "at equal memory" };
  for (const std::string& technique : techniques)
  {
    if (technique != "none")
    {
      header.push_back(technique + " wrong % · ms");
    }
  }
  MarkdownTable table(header);
  for (const double memory : EQUAL_MEMORY)
  {
    std::vector<std::string> row = { std::to_string(int(memory)) + " MiB" };
    for (const std::string& technique : techniques)
    {
      const std::vector<double> at = AtMemory(MapsOf(results, scene, technique), memory);
      if (technique != "none")
      {
        row.push_back(at.empty() ? "-" : Percent(at[1]) + " · " + Milliseconds(at[0]));
      }
    }
    if (std::count(row.begin() + 1, row.end(), "-") < std::ptrdiff_t(row.size()) - 1)
    {
      table.Add(row);
    }
  }
  return table.Text();
}

std::string Scenes(const Results& results, const std::string& folder, const std::string& plots)
{
  std::string text;
  const Selection maps = OfFamily(results, "maps");
  for (const std::string& scene : ValuesOf(maps, "scene"))
  {
    WriteChart(ErrorChart(results, scene), folder + "/" + plots + "/" + scene + ".png");
    text += "### " + scene + "\n\n" + Image("error against time in " + scene, plots, scene) +
      EqualMemory(results, scene) + "<details><summary>All numbers</summary>\n\n";
    MarkdownTable table = LineTable("technique");
    for (const std::string& technique : ValuesOf(maps, "technique"))
    {
      for (const Line* line : maps)
      {
        if (line->Key("scene") == scene && line->Key("technique") == technique)
        {
          table.Add(Row(*line));
        }
      }
    }
    text += table.Text() + "</details>\n\n";
  }
  return text;
}

// Techniques in columns; exponents in the last row.
std::string GrowthTable(const Results& results, const std::string& family)
{
  const Selection lines = OfFamily(results, family);
  const std::vector<std::string> techniques = ValuesOf(lines, "technique");
  std::vector<std::string> header = { family }, exponents = { "exponent" };
  for (const std::string& technique : techniques)
  {
    const auto law = Fit(GrowthCurve(results, family, technique));
    header.push_back(technique + " ms · × vtk");
    exponents.push_back(law ? Times(law->Exponent) : "-");
  }
  MarkdownTable table(header);
  for (const std::string& value : ValuesOf(lines, family))
  {
    std::vector<std::string> row = { value };
    for (const std::string& technique : techniques)
    {
      const Line* line = Pick(lines, { { family, value }, { "technique", technique } });
      row.push_back(
        line ? Milliseconds(line->Value("ms")) + " · " + Times(line->Value("to_vtk")) : "-");
    }
    table.Add(row);
  }
  table.Add(exponents);
  return table.Text();
}

std::string Growth(const Results& results, const std::string& folder, const std::string& plots)
{
  std::string text;
  for (const auto& [family, what] : GrowthFamilies())
  {
    const Selection lines = OfFamily(results, family);
    if (!lines.empty())
    {
      const std::string name = "growth-" + family;
      WriteChart(GrowthChart(results, family, what), folder + "/" + plots + "/" + name + ".png");
      text += "### " + family + " (" + lines.front()->Key("scene") + ")\n\n" +
        Image("time against " + what, plots, name) + GrowthTable(results, family);
    }
  }
  return text;
}

std::string Moving(const Results& results)
{
  const Selection lines = OfFamily(results, "moving");
  std::string text;
  for (const std::string& moving : ValuesOf(lines, "moving"))
  {
    MarkdownTable table = LineTable((moving + " moves").c_str());
    for (const Line* line : lines)
    {
      if (line->Key("moving") == moving)
      {
        table.Add(Row(*line));
      }
    }
    text += table.Text();
  }
  return lines.empty() ? "" : "## What moves\n\n" + text;
}

// Stages in rows, scenes in columns, of one technique.
std::string StageTable(const Selection& maps, const std::string& technique)
{
  static const std::string prefix = "gpu_ms:";
  std::vector<std::string> header = { technique }, stages;
  Selection lines;
  for (const std::string& scene : ValuesOf(maps, "scene"))
  {
    const Line* line =
      Pick(maps, { { "scene", scene }, { "technique", technique }, { "map", USUAL_MAP } });
    if (line)
    {
      header.push_back(scene);
      lines.push_back(line);
      for (const auto& [counter, values] : line->Counters)
      {
        if (counter.compare(0, prefix.size(), prefix) == 0 &&
          std::find(stages.begin(), stages.end(), counter) == stages.end())
        {
          stages.push_back(counter);
        }
      }
    }
  }
  MarkdownTable table(header);
  for (const std::string& stage : stages)
  {
    std::vector<std::string> row = { stage.substr(prefix.size()) };
    for (const Line* line : lines)
    {
      row.push_back(line->Has(stage) ? Milliseconds(line->Value(stage)) : "-");
    }
    table.Add(row);
  }
  return stages.empty() ? "" : table.Text();
}

std::string Stages(const Results& results)
{
  const Selection maps = OfFamily(results, "maps");
  std::string text;
  for (const std::string& technique : ValuesOf(maps, "technique"))
  {
    text += StageTable(maps, technique);
  }
  return text.empty()
    ? ""
    : "## Stages\n\nMilliseconds of the GPU a frame, camera moving, at 1024 × 1024 "
      "texels.\n\n" +
      text;
}
}

std::string WritePage(const Results& results, const std::vector<Change>& changes,
  const std::string& folder, const std::string& plots)
{
  const Line& any = results.Lines.front();
  char window[64];
  std::snprintf(window, sizeof window, "%g × %g", any.Value("width"), any.Value("height"));
  std::string text = "# Results on " + results.Renderer() + "\n\n" + Machine(results) +
    "Wrong are pixels that face the light and whose shadow is not the one that an exact ray finds; "
    "*dark*, *lit*: wrongly so; *far*: more than two pixels from a shadow's edge; *flicker*: "
    "pixels "
    "that change from one tiny move of the camera to the next though the truth does not; "
    "*aliasing*: "
    "how wide a texel is on a surface, in pixels, at the 95th percentile. Times are medians of "
    "whole frames until the GPU has finished; *× vtk*: in times of VTK's own pass with new maps "
    "for each "
    "frame (`vtk`), measured frame by frame in turn, by the CPU time of all threads where OpenGL "
    "is "
    "software and by whole frames elsewhere; `vtk-kept` is VTK's pass as it is by itself, "
    "`none` a frame without shadows. Where nothing else is said the picture has " +
    std::string(window) + " pixels.\n\n" + NoiseText(results);
  for (const Change& change : changes)
  {
    text += "## Since " + change.File + "\n\n" + Tell(change) + "\n";
  }
  if (!OfFamily(results, "maps").empty())
  {
    text += "## Error, time and memory\n\n" + Overview(results) + Scenes(results, folder, plots);
  }
  const std::string growth = Growth(results, folder, plots);
  if (!growth.empty())
  {
    text +=
      "## Growth\n\nFitted to powers: time ~ n^exponent, by least squares of the logarithms.\n\n" +
      growth;
  }
  return text + Moving(results) + Stages(results) + PaperSection(results) +
    VariantSections(results, folder, plots) + ClaimsSection(results);
}

std::string Summary(const Results& results)
{
  const Selection maps = OfFamily(results, "maps");
  if (maps.empty())
  {
    return "";
  }
  MarkdownTable table({ "technique", "wrong %, mean of the scenes", "× vtk, geometric mean" });
  for (const std::string& technique : ValuesOf(maps, "technique"))
  {
    double errors = 0, logarithms = 0;
    int count = 0;
    for (const Line* line : maps)
    {
      if (line->Key("technique") == technique && line->Key("map") == USUAL_MAP)
      {
        errors += line->Value("wrong_percent");
        logarithms += std::log(std::max(line->Value("to_vtk"), 1e-6));
        ++count;
      }
    }
    if (count > 0)
    {
      table.Add({ technique, technique == "none" ? "" : Percent(errors / count),
        Times(std::exp(logarithms / count)) });
    }
  }
  return table.Text();
}
