// SPDX-License-Identifier: BSD-3-Clause
// Layers by depth along the view, split on the GPU by what view samples say, or so that they stay
// in place.
#ifndef rtwDepthSplitStage_h
#define rtwDepthSplitStage_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "Partition/rtwPartitionStage.h"

#include <functional>
#include <map>

namespace rtw
{
struct DepthSplitSettings
{
  int Layers = 4;         ///< layers by depth
  bool Faces = false;     ///< whether each is divided among the four sides of the view frustum
  bool BySamples = false; ///< whether depths are split where the least error is predicted
  double Lambda = 1;      ///< else from 0, even steps of depth, to 1, even ratios
  /// Width of the band where two layers blend, as a share of the nearer one's interval.
  double Blend = 0;
  bool Steady = false; ///< whether layers stay in place in the world
};

class DepthSplitStage : public PartitionStage
{
public:
  static constexpr int MostLayers = 8; // the size of rtwBegin in rtwSplitByBins.glsl

  explicit DepthSplitStage(std::function<DepthSplitSettings()> settings);
  int GetNumberOfLayers() const override
  {
    return this->Settings().Layers * this->GetNumberOfFaces();
  }
  int GetNumberOfFaces() const override { return this->Settings().Faces ? 4 : 1; }
  bool Blends() const override { return this->Settings().Blend > 0; }
  bool NeedsViewSamples() const override { return !this->Settings().Steady; }
  bool Build() override;
  std::string GetLog() const override;
  bool IsFixed(const PartitionInput& input) const override;
  void Split(const PartitionInput& input, LayerTable& table) override;
  std::optional<Rectangle> FocusOf(
    const LightFrame& frame, const PartitionInput& input) const override;
  void Dispose(Disposal dispose) override;

private:
  std::vector<double> FixedBorders(const PartitionInput& input) const;
  void WriteFixed(const PartitionInput& input, LayerTable& table) const;
  void SplitBySamples(const PartitionInput& input, const LayerTable& table);

  std::function<DepthSplitSettings()> Settings;
  Program Binning, Splitting, Writing;
  Buffer Bins, Splits;
  std::map<const void*, glm::dvec2> Steady; ///< the steady range of depths of each viewer
};
}

#endif
