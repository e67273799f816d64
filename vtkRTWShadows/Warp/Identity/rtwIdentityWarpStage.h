// SPDX-License-Identifier: BSD-3-Clause
// The warp that leaves maps as they are.
#ifndef rtwIdentityWarpStage_h
#define rtwIdentityWarpStage_h

#include "Warp/rtwWarpStage.h"

namespace rtw
{
class IdentityWarpStage : public WarpStage
{
public:
  WarpShape GetShape() const override;
  bool NeedsViewSamples() const override { return false; }
  bool DrawsMappersApart() const override { return false; }
  int GetCells() const override { return 1; }
  bool Build() override { return true; }
  std::string GetLog() const override { return {}; }
  void Run(const std::vector<LightFrame>&, const AnalysisInput&, const LayerTable&) override {}
  glm::dvec2 ReadGreatestDensity(int) const override { return glm::dvec2(1); }
  void Dispose(Disposal) override {}
};
}

#endif
