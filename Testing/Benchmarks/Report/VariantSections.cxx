// SPDX-License-Identifier: BSD-3-Clause
#include "Sections.h"

#include "Markdown.h"
#include "Plots.h"
#include "VariantTable.h"

#include <cmath>

namespace
{
// In times of what `base` chooses on the same scene.
std::string RatioTo(
  const Selection& lines, const Line& line, const std::map<std::string, std::string>& base)
{
  std::map<std::string, std::string> keys = base;
  keys["scene"] = line.Key("scene");
  const Line* other = Pick(lines, keys);
  return other ? Times(TimeRatio(line, *other)) : "-";
}

std::string Of(const Line& line, const char* counter, std::string (*print)(double value))
{
  return line.Has(counter) ? print(line.Value(counter)) : "-";
}

std::string WrongAndTime(const Line& line)
{
  return Of(line, "wrong_percent", Percent) + " · " + Milliseconds(line.Value("ms"));
}

// Over all scenes of a variant: the mean error, and the geometric mean of times beside uniform.
std::string MeansOf(const Selection& lines, const Line& any)
{
  double errors = 0, logarithms = 0, count = 0;
  for (const Line* line : lines)
  {
    const Line* base = Pick(lines, { { "scene", line->Key("scene") }, { "technique", "uniform" } });
    if (base && VariantName(*line) == VariantName(any) && line->Has("wrong_percent"))
    {
      errors += line->Value("wrong_percent");
      logarithms += std::log(TimeRatio(*line, *base));
      count += 1;
    }
  }
  return count > 0 ? Percent(errors / count) + " · " + Times(std::exp(logarithms / count)) : "-";
}

std::string Functions(const Results& results, const std::string& folder, const std::string& plots)
{
  const Selection all = OfFamily(results, "functions");
  std::string text = all.empty()
    ? ""
    : "## Importance functions\n\nEvery analysis and importance function. Hybrid is backward where "
      "there are no edges; *published* is desired-view, distance and normal; *user* is the "
      "luminance, *interest* the view's centre.\n\n";
  for (const std::string& map : ValuesOf(all, "map"))
  {
    const Selection lines = Select(all, "map", map);
    text += "### " + map + " × " + map + " texels\n\n" +
      VariantTable(lines, "wrong % · ms · × uniform",
        { { "",
          [&](const Line& line) {
            return WrongAndTime(line) + " · " +
              RatioTo(lines, line, { { "technique", "uniform" } });
          } } },
        { { "means of wrong % · ×", [&](const Line& line) { return MeansOf(lines, line); } } });
    for (const std::string& scene : ValuesOf(lines, "scene"))
    {
      const std::string name = "functions-" + scene + "-" + map;
      WriteChart(FunctionChart(lines, scene), folder + "/" + plots + "/" + name + ".png");
      text +=
        "![error against time of functions in " + scene + "](" + plots + "/" + name + ".png)\n\n";
    }
  }
  return text;
}

std::string Rasterizations(const Results& results)
{
  const Selection all = OfFamily(results, "rasterizations");
  std::string text = all.empty()
    ? ""
    : "## Rasterization\n\nWays to draw the edges that the warp bends; tessellated to so many % of "
      "the map's side. *floor* has two triangles under a few boxes.\n\n";
  for (const std::string& map : ValuesOf(all, "map"))
  {
    const Selection lines = Select(all, "map", map);
    for (const std::string& scene : ValuesOf(lines, "scene"))
    {
      text += VariantTable(Select(lines, "scene", scene), map + " × " + map + " texels",
        { { "wrong %", [](const Line& line) { return Of(line, "wrong_percent", Percent); } },
          { "far %", [](const Line& line) { return Of(line, "far_percent", Percent); } },
          { "ms", [](const Line& line) { return Of(line, "ms", Milliseconds); } },
          { "light pass ms",
            [](const Line& line) { return Of(line, "gpu_ms:light pass", Milliseconds); } },
          { "× linear", [&](const Line& line) {
             return RatioTo(lines, line, { { "variant", "linear" } });
           } } });
    }
  }
  return text;
}

std::string Filters(const Results& results)
{
  const Selection all = OfFamily(results, "filters");
  Selection moving, still;
  for (const Line* line : all)
  {
    (line->Key("moving") == "nothing" ? still : moving).push_back(line);
  }
  std::string text = all.empty()
    ? ""
    : "## Filters\n\nPCF of so many texels, SOFT of so many world units; frames rebuilt while the "
      "camera moves, and *still* ones, in times of nearest.\n\n";
  for (const std::string& map : ValuesOf(all, "map"))
  {
    const Selection rebuilt = Select(moving, "map", map);
    text += VariantTable(rebuilt, map + " × " + map + " texels",
      { { "wrong % · ms · ×",
          [&](const Line& line) {
            return WrongAndTime(line) + " · " +
              RatioTo(rebuilt, line, { { "variant", "nearest" } });
          } },
        { "mask ms", [](const Line& line) { return Of(line, "gpu_ms:mask", Milliseconds); } },
        { "still ms", [&](const Line& line) {
           const Line* kept = Pick(still,
             { { "scene", line.Key("scene") }, { "map", map },
               { "technique", line.Key("technique") }, { "variant", line.Key("variant") } });
           return kept ? Milliseconds(kept->Value("ms")) : "-";
         } } });
  }
  return text;
}

std::string ViewSamples(const Results& results)
{
  const Selection all = OfFamily(results, "view-samples");
  std::string text = all.empty()
    ? ""
    : "## View samples\n\nOf a prepass, and of the previous frame; *samples* is the GPU's time for "
      "them, in times of the frame with a prepass.\n\n";
  for (const std::string& map : ValuesOf(all, "map"))
  {
    const Selection lines = Select(all, "map", map);
    text += VariantTable(lines, map + " × " + map + " texels",
      { { "wrong % · ms · ×",
          [&](const Line& line) {
            return WrongAndTime(line) + " · " + RatioTo(lines, line, { { "variant", "prepass" } });
          } },
        { "far %", [](const Line& line) { return Of(line, "far_percent", Percent); } },
        { "flicker %", [](const Line& line) { return Of(line, "flicker_percent", Percent); } },
        { "samples ms", [](const Line& line) {
           const double sum = StageSum(line, { "view samples", "resampling" });
           return sum > 0 ? Milliseconds(sum) : "-";
         } } });
  }
  return text;
}
}

std::string VariantSections(
  const Results& results, const std::string& folder, const std::string& plots)
{
  return Functions(results, folder, plots) + Rasterizations(results) + Filters(results) +
    ViewSamples(results);
}
