// SPDX-License-Identifier: BSD-3-Clause
#include "Chart.h"

#include "ChartLabels.h"

#include "rtwPictures.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace
{
struct Colour
{
  unsigned char R, G, B;
};

// Greys for what others are compared with; the rest can be told apart by the colour-blind (Okabe
// and Ito).
Colour ColourOf(const std::string& technique)
{
  static const std::map<std::string, Colour> yardsticks = { { "none", { 190, 190, 190 } },
    { "vtk", { 40, 40, 40 } }, { "vtk-kept", { 130, 130, 130 } } };
  static const Colour palette[] = { { 0, 114, 178 }, { 213, 94, 0 }, { 0, 158, 115 },
    { 204, 121, 167 }, { 230, 159, 0 }, { 86, 180, 233 }, { 150, 110, 60 } };
  static std::map<std::string, Colour> given;
  const auto yardstick = yardsticks.find(technique);
  if (yardstick != yardsticks.end())
  {
    return yardstick->second;
  }
  const std::size_t next = given.size() % (sizeof palette / sizeof palette[0]);
  return given.emplace(technique, palette[next]).first->second;
}

int MarkerOf(int shape)
{
  const int markers[] = { vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND,
    vtkPlotPoints::CROSS, vtkPlotPoints::PLUS };
  return markers[std::clamp(shape, 0, 4)];
}

// The chart's own axes are linear, in logarithms: their ticks can then be any.
vtkSmartPointer<vtkTable> TableOf(const std::vector<double>& x, const std::vector<double>& y)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkNew<vtkDoubleArray> xs, ys;
  xs->SetName("x");
  ys->SetName("y");
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    if (x[i] > 0 && y[i] > 0)
    {
      xs->InsertNextValue(std::log10(x[i]));
      ys->InsertNextValue(std::log10(y[i]));
    }
  }
  table->AddColumn(xs);
  table->AddColumn(ys);
  return table;
}

struct Range
{
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();

  void Add(const std::vector<double>& values)
  {
    for (const double value : values)
    {
      if (value > 0)
      {
        this->Low = std::min(this->Low, std::log10(value));
        this->High = std::max(this->High, std::log10(value));
      }
    }
  }
};

std::string TickLabel(double value)
{
  char text[32];
  if (value >= 1e6)
  {
    std::snprintf(text, sizeof text, "%g M", value / 1e6);
  }
  else
  {
    std::snprintf(
      text, sizeof text, value >= 1e4 ? "%g k" : "%g", value / (value >= 1e4 ? 1e3 : 1));
  }
  return text;
}

// 1, 2, 5 of each decade, or less where that is too many.
void SetTicks(vtkAxis* axis, Range range)
{
  const double margin = std::max(0.06 * (range.High - range.Low), 0.02);
  range.Low -= margin;
  range.High += margin;
  const double decades = range.High - range.Low;
  const std::vector<double> steps = decades > 3.5 ? std::vector<double>{ 1 }
    : decades > 0.9                               ? std::vector<double>{ 1, 2, 5 }
                    : std::vector<double>{ 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9 };
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (int decade = int(std::floor(range.Low)); decade <= int(std::ceil(range.High)); ++decade)
  {
    for (const double step : steps)
    {
      const double at = std::log10(step) + decade;
      if (at >= range.Low && at <= range.High)
      {
        positions->InsertNextValue(at);
        // Without the spaces the left axis cuts short labels off.
        labels->InsertNextValue("  " + TickLabel(step * std::pow(10.0, decade)) + " ");
      }
    }
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(range.Low, range.High);
  axis->SetCustomTickPositions(positions, labels);
}

void SetAxis(vtkAxis* axis, const std::string& title, const Range& range)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(17);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(15);
  axis->GetGridPen()->SetColor(228, 228, 228);
  SetTicks(axis, range);
}

// vtkPlotLine is a vtkPlotPoints too.
void AddLine(vtkChartXY* chart, const ChartLine& line)
{
  const Colour colour = ColourOf(line.Technique);
  const vtkSmartPointer<vtkTable> table = TableOf(line.Points.X, line.Points.Y);
  // Of less than two points no line can be drawn.
  const bool isPoint = line.Scattered || table->GetNumberOfRows() < 2;
  auto* plot =
    vtkPlotPoints::SafeDownCast(chart->AddPlot(isPoint ? vtkChart::POINTS : vtkChart::LINE));
  plot->SetInputData(table, 0, 1);
  plot->SetColor(colour.R, colour.G, colour.B, 255);
  plot->SetWidth(line.Dashed ? 1.2f : 2.6f);
  plot->GetPen()->SetLineType(line.Dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  plot->SetLabel(line.Points.Name);
  plot->SetLegendVisibility(!line.Dashed);
  if (line.Marked || isPoint)
  {
    plot->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    plot->SetMarkerSize(8);
  }
}

void AddMarks(vtkChartXY* chart, const MarkSeries& marks)
{
  auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(vtkChart::POINTS));
  plot->SetInputData(TableOf(marks.X, marks.Y), 0, 1);
  plot->SetColor(20, 20, 20, 255);
  plot->SetMarkerStyle(MarkerOf(marks.Shape));
  plot->SetMarkerSize(11);
  plot->SetWidth(1.5f);
  plot->SetLabel(marks.Name);
}

std::vector<PointLabel> LabelsOf(const Chart& chart)
{
  std::vector<PointLabel> labels;
  for (const ChartLine& line : chart.Lines)
  {
    for (std::size_t i = 0; i < line.Labels.size(); ++i)
    {
      const double x = line.Points.X[i], y = line.Points.Y[i];
      if (x > 0 && y > 0)
      {
        labels.push_back({ line.Labels[i], std::log10(x), std::log10(y) });
      }
    }
  }
  return labels;
}

void Fill(vtkChartXY* chart, const Chart& from)
{
  Range x, y;
  for (const ChartLine& line : from.Lines)
  {
    AddLine(chart, line);
    x.Add(line.Points.X);
    y.Add(line.Points.Y);
  }
  for (const MarkSeries& marks : from.Marks)
  {
    AddMarks(chart, marks);
  }
  chart->SetTitle(from.Title);
  chart->GetTitleProperties()->SetFontSize(20);
  if (!LabelsOf(from).empty())
  {
    x.High += 0.5 * (x.High - x.Low); // the labels' place
  }
  SetAxis(chart->GetAxis(vtkAxis::BOTTOM), from.XTitle, x);
  SetAxis(chart->GetAxis(vtkAxis::LEFT), from.YTitle, y);
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->SetInline(false);
  legend->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->SetLabelSize(15);
  legend->SetSymbolWidth(30);
}
}

void WriteChart(const Chart& from, const std::string& path)
{
  vtkNew<vtkContextView> view;
  vtkRenderWindow* window = view->GetRenderWindow();
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(4);
  window->SetSize(900, 560);
  view->GetRenderer()->SetBackground(1, 1, 1);
  vtkNew<vtkChartXY> chart;
  Fill(chart, from);
  view->GetScene()->AddItem(chart);
  window->Render();
  const std::vector<PointLabel> labels = LabelsOf(from);
  if (!labels.empty())
  {
    vtkNew<ChartLabels> names;
    names->SetLabels(chart, labels);
    view->GetScene()->AddItem(names);
    window->Render();
  }
  rtw::WritePng(rtw::Grab(window), path);
}
