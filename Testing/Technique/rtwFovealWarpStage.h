// SPDX-License-Identifier: BSD-3-Clause
// A warp that the module knows nothing of. It goes by a function in closed form, the same for every
// layer, so that it fills no table and holds nothing on the GPU.
#ifndef rtwFovealWarpStage_h
#define rtwFovealWarpStage_h

#include "Warp/rtwWarpStage.h"

namespace rtw
{
/// The twin of rtwWarpFoveal.glsl along one axis, in double precision.
class FovealFunction
{
public:
  static constexpr double Sharpness = 3;

  static double Forward(double onFocus);
  static double Inverse(double onMap);
  static double GreatestSlope();
};

class FovealWarpStage : public WarpStage
{
public:
  WarpShape GetShape() const override;
  bool NeedsViewSamples() const override { return false; }
  int GetCells() const override { return 1; }
  bool Build() override { return true; }
  std::string GetLog() const override { return {}; }
  void Run(const std::vector<LightFrame>&, const AnalysisInput&, const LayerTable&) override {}
  glm::dvec2 ReadGreatestDensity(int) const override
  {
    return glm::dvec2(FovealFunction::GreatestSlope());
  }
  void Dispose(Disposal) override {}
};
}

#endif
