// SPDX-License-Identifier: BSD-3-Clause
// What tests of layers by depth look at.
#ifndef rtwCascadeStage_h
#define rtwCascadeStage_h

#include "rtwShadowStage.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkCascadedShadowMapPass;

/// Cascades over a floor that reaches far, with boxes in two groups and nothing between them, under
/// a sun.
struct rtwCascadeStage : rtwShadowStage
{
  explicit rtwCascadeStage(const char* name);
  vtkCascadedShadowMapPass* GetPass();
  /// A frame's errors, in percent; says them.
  double Measure();
  /// How far the nearest and the farthest pixel are that face the sun; fills Depths.
  glm::dvec2 FindDepths();
  /// Of a light's layer in the last frame.
  glm::dvec2 GetRange(int light, int layer);

  vtkLight* Sun;
  std::vector<double> Depths; ///< of each pixel; 0 where nothing faces the sun
};

#endif
