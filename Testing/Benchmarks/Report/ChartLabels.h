// SPDX-License-Identifier: BSD-3-Clause
// Names of points, in a column at the right edge of a chart.
#ifndef ChartLabels_h
#define ChartLabels_h

#include <vtkContextItem.h>

#include <string>
#include <vector>

class vtkChartXY;

struct PointLabel
{
  std::string Text;
  double X, Y; // as the axes have them
};

/// Draws names one below the other, each with a line to its point. To be added to the scene when
/// the chart has been drawn once, since it knows its axes' places only then.
class ChartLabels : public vtkContextItem
{
public:
  static ChartLabels* New();
  vtkTypeMacro(ChartLabels, vtkContextItem);

  void SetLabels(vtkChartXY* chart, std::vector<PointLabel> labels);
  bool Paint(vtkContext2D* painter) override;

private:
  vtkChartXY* Chart = nullptr;
  std::vector<PointLabel> Labels;
};

#endif
