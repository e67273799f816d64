// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison.h"

#include "rtwQuantile.h"

#include <algorithm>
#include <cmath>

namespace
{
// A change is noise if it is within three standard deviations of a difference of two means, or
// within what two runs of one build were seen to differ by.
constexpr double DEVIATIONS = 3;
constexpr double LEAST_TIME_NOISE = 0.08;
// Shadows are the same in each lap, so their noise is none; but a few pixels on edges may go either
// way when a formula is only written otherwise.
constexpr double PIXEL_SHARE = 0.005;
constexpr double PIXELS = 3;
constexpr double MEMORY_SHARE = 0.01;

double StandardError(const Line& line, const std::string& counter)
{
  const auto at = line.Counters.find(counter);
  const double laps = at == line.Counters.end() ? 1 : double(at->second.size());
  return line.Noise(counter) / std::sqrt(laps);
}

void FlagIf(const Line& before, const Line& after, const char* counter, const char* what,
  const char* unit, double tolerance, Comparison& comparison)
{
  const double old = before.Value(counter), now = after.Value(counter);
  if (before.Has(counter) && after.Has(counter) && now > old + tolerance)
  {
    comparison.Flags.push_back({ after.Name, what, unit, old, now, tolerance });
  }
}

// Times in times of VTK's pass, which the machine's load does not change; that pass itself in times
// of a frame without shadows.
void CompareTimes(const Line& before, const Line& after, Comparison& comparison)
{
  const std::string technique = after.Key("technique");
  if (technique == "none")
  {
    return;
  }
  const bool isYardstick = technique == "vtk";
  const char* counter = isYardstick ? "to_none" : "to_vtk";
  const double noise =
    DEVIATIONS * std::hypot(StandardError(before, counter), StandardError(after, counter));
  FlagIf(before, after, counter, "slower",
    isYardstick ? "times a frame without shadows" : "times VTK's own pass",
    before.Value(counter) * std::max(noise, LEAST_TIME_NOISE), comparison);
}

void ComparePixels(const Line& before, const Line& after, Comparison& comparison)
{
  if (!before.Has("wrong_pixels") || !after.Has("wrong_pixels"))
  {
    return;
  }
  ++comparison.WithPixels;
  comparison.EqualPixels += before.Value("wrong_pixels") == after.Value("wrong_pixels");
  const double old = before.Value("wrong_pixels");
  FlagIf(before, after, "wrong_pixels", "less accurate", "wrong pixels",
    std::max(PIXEL_SHARE * old, PIXELS), comparison);
}

bool AreAlike(const Line& before, const Line& after)
{
  const char* const counters[] = { "width", "height", "triangles", "actors", "lights", "pixels" };
  return std::all_of(std::begin(counters), std::end(counters),
    [&](const char* counter) { return before.Value(counter) == after.Value(counter); });
}
}

Comparison Compare(const Results& before, const Results& after)
{
  Comparison comparison;
  std::vector<double> ratios;
  for (const Line& old : before.Lines)
  {
    const Line* now = after.Find(old.Name);
    if (!now)
    {
      comparison.Missing.push_back(old.Name);
      continue;
    }
    if (!AreAlike(old, *now))
    {
      comparison.Unlike.push_back(old.Name);
      continue;
    }
    ++comparison.Compared;
    CompareTimes(old, *now, comparison);
    ComparePixels(old, *now, comparison);
    FlagIf(old, *now, "memory_bytes", "more memory", "bytes",
      MEMORY_SHARE * old.Value("memory_bytes"), comparison);
    if (old.Key("technique") != "none" && old.Value("to_vtk") > 0 && now->Value("to_vtk") > 0)
    {
      const double ratio = now->Value("to_vtk") / old.Value("to_vtk");
      ratios.push_back(std::max(ratio, 1 / ratio));
      comparison.LargestTimeRatio = std::max(comparison.LargestTimeRatio, ratios.back());
    }
  }
  comparison.MiddleTimeRatio = ratios.empty() ? 1 : rtw::Median(ratios);
  return comparison;
}
