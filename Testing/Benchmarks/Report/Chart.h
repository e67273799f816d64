// SPDX-License-Identifier: BSD-3-Clause
#ifndef Chart_h
#define Chart_h

#include "Curves.h"

#include <string>
#include <vector>

/// A mark at single points, whatever line they lie on.
struct MarkSeries
{
  std::string Name;
  int Shape = 0; // 0 to 4
  std::vector<double> X, Y;
};

struct ChartLine
{
  Curve Points;
  std::string Technique; // decides the colour
  bool Dashed = false;   // and thin, and not in the legend
  bool Marked = false;   // with a dot at each point
  bool Scattered = false;          // points, with no line
  std::vector<std::string> Labels; // of the points; none if empty
};

/// A chart with logarithmic axes.
struct Chart
{
  std::string Title, XTitle, YTitle;
  std::vector<ChartLine> Lines;
  std::vector<MarkSeries> Marks;
};

/// Draws it by VTK's charts. Throws std::runtime_error if the file cannot be written.
void WriteChart(const Chart& chart, const std::string& path);

#endif
