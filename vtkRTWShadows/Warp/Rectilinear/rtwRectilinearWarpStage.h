// SPDX-License-Identifier: BSD-3-Clause
// Rectilinear texture warping on the GPU: importance, then warping maps.
#ifndef rtwRectilinearWarpStage_h
#define rtwRectilinearWarpStage_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "Importance/rtwImportanceStage.h"
#include "Warp/Rectilinear/rtwUsedCells.h"
#include "Warp/Rectilinear/rtwWarpHistory.h"
#include "Warp/rtwWarpStage.h"

#include <functional>

namespace rtw
{
struct RectilinearSettings
{
  ImportanceSettings Importance;
  int LightImageSize = 512;
  int Cells = 512;
  double Sigma = 3;    ///< standard deviation of the blur, in cells
  double Floor = 0.01; ///< least importance, as a share of the mean
  double Blending = 0; ///< share of the last frame's function that is kept
  bool Snapping = false;
  bool CullsCells = false;

  bool Remembers() const { return this->Blending > 0 || this->Snapping; }
};

class RectilinearWarpStage : public WarpStage
{
public:
  /// `refused` is told why the user's importance function doesn't compile.
  RectilinearWarpStage(std::function<RectilinearSettings()> settings,
    std::function<void(const std::string& log)> refused);
  WarpShape GetShape() const override;
  bool NeedsViewSamples() const override { return true; }
  int GetCells() const override { return this->Settings().Cells; }
  int GetLightImageSize() const override;
  void Follow(const WarpFrame& frame, const LayerTable& table) override;
  bool IsSettled() const override { return this->Settled; }
  bool Build() override;
  std::string GetLog() const override;
  void Run(const std::vector<LightFrame>& frames, const AnalysisInput& input,
    const LayerTable& table) override;
  glm::dvec2 ReadGreatestDensity(int layer) const override;
  std::vector<float> ReadImportance(int layer, const LayerTable& table) const override;
  void Dispose(Disposal dispose) override;

private:
  std::function<RectilinearSettings()> Settings;
  ImportanceStage Importance;
  Program Building, FocusSnapping;
  Buffer Report, Profiles;
  int Cells = 0; ///< cells of each profile
  int Layers = 0;
  WarpHistory History;
  UsedCells InUse;
  bool Settled = true;
};
}

#endif
