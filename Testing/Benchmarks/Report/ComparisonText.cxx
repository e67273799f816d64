// SPDX-License-Identifier: BSD-3-Clause
#include "Page.h"

#include <cstdio>

namespace
{
template <class... Values>
std::string Format(const char* format, Values... values)
{
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}
}

std::string Tell(const Change& change)
{
  const Comparison& found = change.Found;
  std::string text = Format(
    "%zu lines are in both. Wrong pixels are exactly as many in %zu of %zu. Ratios to VTK's pass "
    "differ by %.1f %% in the middle and %.1f %% at most.\n\n",
    found.Compared, found.EqualPixels, found.WithPixels, 100 * (found.MiddleTimeRatio - 1),
    100 * (found.LargestTimeRatio - 1));
  for (const Flag& flag : found.Flags)
  {
    text += Format("- **%s**: %s: %.6g instead of %.6g %s (noise: %.2g)\n", flag.What.c_str(),
      flag.Line.c_str(), flag.After, flag.Before, flag.Unit.c_str(), flag.Tolerance);
  }
  if (found.Flags.empty())
  {
    text += "- No line has become slower, less accurate or larger by more than noise.\n";
  }
  for (const std::string& name : found.Unlike)
  {
    text += "- not comparable, measured on something else: " + name + "\n";
  }
  if (!found.Missing.empty())
  {
    text += Format("- %zu lines are not measured any more, %s first\n", found.Missing.size(),
      found.Missing.front().c_str());
  }
  return text;
}
