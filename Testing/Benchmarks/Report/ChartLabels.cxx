// SPDX-License-Identifier: BSD-3-Clause
#include "ChartLabels.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <algorithm>

vtkStandardNewMacro(ChartLabels);

namespace
{
constexpr float STEP = 15;    // pixels from one name to the next
constexpr float COLUMN = 190; // of names, in pixels
constexpr float GAP = 3;      // between a line and its name

// In pixels along one side of the picture.
float PixelOf(vtkAxis* axis, int side, double value)
{
  const double share = (value - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
  const float from = axis->GetPoint1()[side], to = axis->GetPoint2()[side];
  return from + float(share) * (to - from);
}
}

void ChartLabels::SetLabels(vtkChartXY* chart, std::vector<PointLabel> labels)
{
  this->Chart = chart;
  this->Labels = std::move(labels);
  std::sort(this->Labels.begin(), this->Labels.end(),
    [](const PointLabel& a, const PointLabel& b) { return a.Y < b.Y; });
}

bool ChartLabels::Paint(vtkContext2D* painter)
{
  vtkAxis *bottom = this->Chart->GetAxis(vtkAxis::BOTTOM),
          *left = this->Chart->GetAxis(vtkAxis::LEFT);
  const float right = bottom->GetPoint2()[0] - COLUMN;
  const float top = left->GetPoint2()[1] - STEP;
  std::vector<float> heights;
  for (const PointLabel& label : this->Labels)
  {
    const float own = PixelOf(left, 1, label.Y);
    heights.push_back(heights.empty() ? own : std::max(own, heights.back() + STEP));
  }
  // Those that were pushed out at the top push the others back down.
  float limit = top;
  for (auto height = heights.rbegin(); height != heights.rend(); ++height, limit -= STEP)
  {
    *height = std::min(*height, limit);
    limit = *height;
  }
  painter->GetTextProp()->SetFontSize(12);
  painter->GetTextProp()->SetColor(0.1, 0.1, 0.1);
  painter->GetTextProp()->SetJustificationToLeft();
  painter->GetTextProp()->SetVerticalJustificationToCentered();
  painter->GetPen()->SetColor(170, 170, 170);
  painter->GetPen()->SetWidth(1);
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  for (std::size_t i = 0; i < this->Labels.size(); ++i)
  {
    const PointLabel& label = this->Labels[i];
    painter->DrawLine(
      PixelOf(bottom, 0, label.X), PixelOf(left, 1, label.Y), right - GAP, heights[i]);
    painter->DrawString(right, heights[i], label.Text);
  }
  return true;
}
