// SPDX-License-Identifier: BSD-3-Clause
// Non-orthogonal texture warping on the GPU: what each cell of a grid asks for, then a function for
// each row, and, of what those make of it, one for each column.
#ifndef rtwNonOrthogonalWarpStage_h
#define rtwNonOrthogonalWarpStage_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwTexelBuffer.h"
#include "Warp/rtwWarpStage.h"

#include <functional>

namespace rtw
{
struct NonOrthogonalSettings
{
  /// Whether cells weigh the square root of demand; else samples are counted.
  bool Demand = true;
  int Cells = 512;       ///< along both axes
  bool Automatic = true; ///< whether smoothing is chosen by what it costs
  double Smoothing =
    0.05;           ///< otherwise, of what neighbouring lines ask for: σ, as a share of the focus
  double Sigma = 2; ///< standard deviation of the blur along a line, in cells
  double Floor = 0.01; ///< least importance, as a share of a line's mean
};

class NonOrthogonalWarpStage : public WarpStage
{
public:
  explicit NonOrthogonalWarpStage(std::function<NonOrthogonalSettings()> settings);
  WarpShape GetShape() const override;
  bool NeedsViewSamples() const override { return true; }
  int GetCells() const override { return this->Settings().Cells; }
  bool Build() override;
  std::string GetLog() const override;
  void Run(const std::vector<LightFrame>& frames, const AnalysisInput& input,
    const LayerTable& table) override;
  glm::dvec2 ReadGreatestDensity(int layer) const override;
  std::vector<float> ReadImportance(int layer, const LayerTable& table) const override;
  void Dispose(Disposal dispose) override;

private:
  Program& Collecting(bool demand) { return demand ? this->CollectingDemand : this->Counting; }
  void Collect(const LightFrame& frame, int layer, int axis, const AnalysisInput& input,
    const LayerTable& table);
  float Unit() const; ///< the value of a collected integer of 1
  bool BuildChoosing();
  int FirstOf(int layer, int axis) const; ///< cell that is collected
  void ChooseRadius(int layer, int axis, const LayerTable& table, double straight);
  void Smooth(int layer, int axis, const LayerTable& table);
  void BuildFunctions(int layer, int axis, const LayerTable& table);
  void Invert(int layer, const LayerTable& table);
  void BuildPyramid(int layer, const LayerTable& table);
  void BuildTiles(int layer, const LayerTable& table);

  std::function<NonOrthogonalSettings()> Settings;
  NonOrthogonalSettings Used; ///< the settings of the frame at work
  Program Counting, CollectingDemand, SmoothingFirst, Smoothing, Coarsening, Costing, Choosing,
    Building, Inverting, Levelling, Tiling;
  TexelBuffer Collected; ///< a layer, an axis, a line, a cell: low and high part of a sum
  TexelBuffer Smoothed;
  TexelBuffer Coarse;
  Buffer Costs, Radius; ///< the choice of smoothing
  Buffer Totals;        ///< a layer, an axis, a line: importance as it was used
  Buffer Report;        ///< a layer, an axis: the greatest slope
  int Layers = 0;
  int Cells = 0;
  /// Cells from the beginning of a collected or smoothed line to that of the next.
  int LineLength = 0;
};
}

#endif
