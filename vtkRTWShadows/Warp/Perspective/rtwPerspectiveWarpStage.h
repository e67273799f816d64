// SPDX-License-Identifier: BSD-3-Clause
// The perspective warp on the GPU: chosen by the nearest view sample and the focus, then fitted to
// what samples take of the map.
//
// For another warp on top of it, that one's focus would be this one's map: its rtwWarp would follow
// rtwWarp here, its texel centres go before the inverse here, slopes be multiplied, and its
// importance be collected where this one has put the samples; and the table would need a row more
// for each layer.
#ifndef rtwPerspectiveWarpStage_h
#define rtwPerspectiveWarpStage_h

#include "Frame/rtwView.h"
#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "Layers/rtwSampleBounds.h"
#include "Warp/Perspective/rtwPerspectiveWarp.h"
#include "Warp/Perspective/rtwResolutionSplit.h"
#include "Warp/rtwWarpStage.h"

#include <functional>

namespace rtw
{
/// How texels are divided between s and t.
struct SplitSettings
{
  enum Kinds
  {
    Given,
    Critical, ///< Equations 13 and 14
    LeastError
  };
  int Kind = Given;
  double Ratio = 1; ///< texels along s over those along t, for ByRatio
};

class PerspectiveWarpStage : public WarpStage
{
public:
  PerspectiveWarpStage(
    std::function<PerspectiveChoice()> choice, std::function<SplitSettings()> split);
  WarpShape GetShape() const override;
  bool NeedsViewSamples() const override { return true; }
  int GetCells() const override { return 1; }
  bool LiesAlongView() const override { return true; }
  double ChooseTexelRatio(const SplitScene& scene) override;
  bool SplitsByError() const override { return this->Split().Kind == SplitSettings::LeastError; }
  bool Build() override;
  std::string GetLog() const override;
  void Follow(const WarpFrame& frame, const LayerTable& table) override;
  void Run(const std::vector<LightFrame>& frames, const AnalysisInput& input,
    const LayerTable& table) override;
  glm::dvec2 ReadGreatestDensity(int layer) const override;
  void Dispose(Disposal dispose) override;

private:
  void FindNearest(
    const LightFrame& frame, int layer, const AnalysisInput& input, const LayerTable& table);
  void FindBounds(const LightFrame& frame, const AnalysisInput& input, const LayerTable& table);
  void Write(const LightFrame& frame, int layer, int pass, const AnalysisInput& input,
    const LayerTable& table);

  std::function<PerspectiveChoice()> Choice;
  std::function<SplitSettings()> Split;
  SteadyRatio Ratio;
  View Viewed; ///< the view of the frame at work
  bool Focused = true;
  bool Current = true; ///< whether samples are of that frame
  Program Looking, Building;
  SampleBounds Bounding;
  Buffer Nearest, Bounds;
  Buffer Report; ///< a layer: as rtwWarpPerspective.glsl has it
  int Layers = 0;
};
}

#endif
