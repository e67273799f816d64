// SPDX-License-Identifier: BSD-3-Clause
#include "Plots.h"

#include <algorithm>
#include <cstdio>

const std::vector<double> EQUAL_MEMORY = { 2, 8, 32, 128, 512 };

namespace
{
constexpr double MEBIBYTE = 1048576;

std::vector<std::string> Techniques(const Selection& lines)
{
  return ValuesOf(lines, "technique");
}
}

Selection MapsOf(const Results& results, const std::string& scene, const std::string& technique)
{
  Selection maps;
  for (const Line* line : OfFamily(results, "maps"))
  {
    if (line->Key("scene") == scene && line->Key("technique") == technique &&
      line->Has("wrong_percent"))
    {
      maps.push_back(line);
    }
  }
  std::sort(maps.begin(), maps.end(),
    [](const Line* a, const Line* b) { return a->Value("resolution") < b->Value("resolution"); });
  return maps;
}

std::vector<double> AtMemory(const Selection& maps, double mebibytes)
{
  std::vector<double> memory, times, errors;
  for (const Line* line : maps)
  {
    memory.push_back(line->Value("memory_bytes") / MEBIBYTE);
    times.push_back(line->Value("ms"));
    errors.push_back(line->Value("wrong_percent"));
  }
  const auto time = Interpolate(memory, times, mebibytes);
  const auto error = Interpolate(memory, errors, mebibytes);
  return time && error ? std::vector<double>{ *time, *error } : std::vector<double>();
}

Chart ErrorChart(const Results& results, const std::string& scene)
{
  Chart chart;
  chart.Title = scene + ": wrong pixels against time";
  chart.XTitle = "milliseconds a frame, camera moving";
  chart.YTitle = "wrong pixels, % of those that face the light";
  for (std::size_t i = 0; i < EQUAL_MEMORY.size(); ++i)
  {
    char name[32];
    std::snprintf(name, sizeof name, "%g MiB", EQUAL_MEMORY[i]);
    chart.Marks.push_back({ name, int(i), {}, {} });
  }
  for (const std::string& technique : Techniques(OfFamily(results, "maps")))
  {
    const Selection maps = MapsOf(results, scene, technique);
    ChartLine line;
    line.Technique = line.Points.Name = technique;
    for (const Line* map : maps)
    {
      line.Points.X.push_back(map->Value("ms"));
      line.Points.Y.push_back(map->Value("wrong_percent"));
    }
    for (std::size_t i = 0; i < EQUAL_MEMORY.size(); ++i)
    {
      const std::vector<double> at = AtMemory(maps, EQUAL_MEMORY[i]);
      if (!at.empty())
      {
        chart.Marks[i].X.push_back(at[0]);
        chart.Marks[i].Y.push_back(at[1]);
      }
    }
    if (!maps.empty())
    {
      chart.Lines.push_back(line);
    }
  }
  const auto isEmpty = [](const MarkSeries& marks) { return marks.X.empty(); };
  chart.Marks.erase(
    std::remove_if(chart.Marks.begin(), chart.Marks.end(), isEmpty), chart.Marks.end());
  return chart;
}

std::vector<std::pair<std::string, std::string>> GrowthFamilies()
{
  return { { "triangles", "triangles" }, { "actors", "actors" }, { "lights", "lights" },
    { "window", "pixels" }, { "outside", "triangles, most behind the camera" } };
}

Curve GrowthCurve(const Results& results, const std::string& family, const std::string& technique)
{
  Curve curve;
  curve.Name = technique;
  for (const Line* line : OfFamily(results, family))
  {
    if (line->Key("technique") == technique)
    {
      curve.X.push_back(family == "window" ? line->Value("width") * line->Value("height")
          : family == "outside"            ? line->Value("triangles")
                                           : line->Value(family));
      curve.Y.push_back(line->Value("ms"));
    }
  }
  return curve;
}

Chart GrowthChart(const Results& results, const std::string& family, const std::string& what)
{
  Chart chart;
  const Selection lines = OfFamily(results, family);
  chart.Title = ValuesOf(lines, "scene").front() + ": time against " + what;
  chart.XTitle = what;
  chart.YTitle = "milliseconds a frame, camera moving";
  for (const std::string& technique : Techniques(lines))
  {
    ChartLine line;
    line.Points = GrowthCurve(results, family, technique);
    line.Technique = technique;
    line.Marked = true;
    const auto law = Fit(line.Points);
    if (law)
    {
      char exponent[32];
      std::snprintf(exponent, sizeof exponent, "  ~ n^%.2f", law->Exponent);
      line.Points.Name += exponent;
      ChartLine fitted;
      fitted.Technique = technique;
      fitted.Dashed = true;
      fitted.Points.X = { line.Points.X.front(), line.Points.X.back() };
      fitted.Points.Y = { law->At(line.Points.X.front()), law->At(line.Points.X.back()) };
      chart.Lines.push_back(fitted);
    }
    chart.Lines.push_back(line);
  }
  return chart;
}

Chart FunctionChart(const Selection& lines, const std::string& scene)
{
  Chart chart;
  chart.Title = scene + ": wrong pixels against time of importance functions";
  chart.XTitle = "milliseconds a frame, camera moving";
  chart.YTitle = "wrong pixels, % of those that face the light";
  for (const Line* line : lines)
  {
    const std::string variant = line->Key("variant");
    const std::size_t plus = variant.find('+');
    const std::string name = variant.empty() ? line->Key("technique") : variant.substr(0, plus);
    if (line->Key("scene") != scene || name == "none" || name == "vtk")
    {
      continue;
    }
    auto at = std::find_if(chart.Lines.begin(), chart.Lines.end(),
      [&](const ChartLine& points) { return points.Technique == name; });
    if (at == chart.Lines.end())
    {
      ChartLine points;
      points.Technique = points.Points.Name = name;
      points.Scattered = true;
      at = chart.Lines.insert(at, points);
    }
    at->Points.X.push_back(line->Value("ms"));
    at->Points.Y.push_back(line->Value("wrong_percent"));
    at->Labels.push_back(variant.empty() ? name : variant.substr(plus + 1));
  }
  return chart;
}
