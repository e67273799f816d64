// SPDX-License-Identifier: BSD-3-Clause
// Backward analysis (Rosen 2012, section 4.1): the importance of each column and row of the light plane, from the view samples.
#ifndef rtwImportanceStage_h
#define rtwImportanceStage_h

#include "rtwBuffer.h"
#include "rtwLightFrame.h"
#include "rtwProgram.h"

#include <vector>

namespace rtw
{
class ViewSampler;
class WarpTable;

/// Bits of importance functions; any set of them is a product.
enum ImportanceFunction
{
  DesiredView = 1,
  DistanceToEye = 2,
  SurfaceNormal = 4,
  SqrtDemand = 8
};

class ImportanceStage
{
public:
  static constexpr int MostCells = 2048;

  bool Build();
  const std::string& GetLog() const { return this->Analysis.GetLog(); }
  /// One frame a layer; the profile holds two integers a cell, all cells of both axes for each layer.
  void Analyse(const std::vector<LightFrame>& frames, int functions, const ViewSampler& samples,
    int stride,
    const WarpTable& table);
  const Buffer& GetProfile() const { return this->Profile; }
  void Release();
  void Abandon();

private:
  Program Analysis;
  Buffer Profile;
};
}

#endif
