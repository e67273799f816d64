// SPDX-License-Identifier: BSD-3-Clause
// Where depths along the view are split, in double precision: the twin of what the GPU does, and
// what needs no view samples.
#ifndef rtwDepthSplits_h
#define rtwDepthSplits_h

#include "Layers/rtwFocus.h"
#include "Light/rtwLightFrame.h"

#include <glm/glm.hpp>

#include <vector>

namespace rtw
{
struct View;

/// The borders of so many layers, the range's two ends among them: at even ratios (lambda 1; Lloyd
/// et al. 2006, equations 15 and 16), even steps (0), or between (Zhang et al. 2006).
std::vector<double> SplitDepths(const glm::dvec2& range, int layers, double lambda);

/// What lies between two depths, as layers see it.
struct DepthBin
{
  Rectangle Bounds;       ///< on the light plane
  glm::dvec2 Demand{ 0 }; ///< the sum, over its samples, of one over the footprint along s and t
  bool Any = false;
};

/// Splits bins into at most so many runs, so that the error which layers that are fitted to them
/// are predicted to have, the sum of extent times demand, is least: the first bin of each.
std::vector<int> SplitBins(const std::vector<DepthBin>& bins, int layers);

/// A range of depths that holds that of a view's projection: the one that was held before, as long
/// as it does and isn't much wider; 0 to 0 for none.
glm::dvec2 SteadyRange(const View& seen, const glm::dvec2& held);

/// The corners, in world coordinates, of what a view shows between two depths.
std::vector<glm::dvec3> SliceCorners(const View& seen, double nearest, double farthest);

/// A square on the light plane that holds what the view shows between two depths, and what a filter
/// reaches from there, with so many texels a side which stay where they are in the world while the
/// camera moves; of a directional light whichever way it looks, too.
Rectangle SteadyFocus(const LightFrame& frame, const View& view, const glm::dvec2& depths,
  const FilterReach& reach, int resolution);
}

#endif
