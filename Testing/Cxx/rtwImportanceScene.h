// SPDX-License-Identifier: BSD-3-Clause
// A small ball above a large floor, and the warping maps that importance functions make of it.
#ifndef rtwImportanceScene_h
#define rtwImportanceScene_h

#include "rtwShadowStage.h"

#include "vtkRTWShadowMapPass.h"

#include <array>
#include <string>
#include <vector>

class rtwImportanceScene : public rtwShadowStage
{
public:
  /// Values of the warping maps at the borders of their cells, along s and t.
  using Maps = std::array<std::vector<double>, 2>;

  explicit rtwImportanceScene(bool ball = true);

  /// One frame's.
  Maps MapsWith(int importance, int analysis = vtkRTWShadowMapPass::BACKWARD, int light = 0);
  /// Those of a user's function, times other functions.
  Maps MapsOf(const std::string& code, int others = 0);
  Maps GetMaps(int light = 0);
  /// Of texels along an axis, at a point, in times the mean.
  double DensityAt(const std::array<double, 3>& point, int axis, const Maps& maps);

  vtkRTWShadowMapPass* Warped; ///< the stage's
};

/// Checks that no value of two maps differs by more, or that one differs by at least so much.
void rtwCheckAlike(const std::string& what, const rtwImportanceScene::Maps& a,
  const rtwImportanceScene::Maps& b, double most = 1e-5);
void rtwCheckApart(const std::string& what, const rtwImportanceScene::Maps& a,
  const rtwImportanceScene::Maps& b, double least = 0.01);

#endif
