// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwAliasing_h
#define rtwAliasing_h

#include "rtwReference.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace rtw
{
/// Where a point of the world lies on a shadow map, in texels.
using TexelFunction = std::function<glm::dvec2(const glm::dvec3& world)>;

/// The aliasing error m = w'_l / w'_i: how wide a texel's footprint on a surface is, beside a
/// pixel's (Lloyd et al., Warping and Partitioning for Low Error Shadow Maps, 2006, equation 1, the
/// exact form with the projection of both onto the surface). Where it is above one, pixels show the
/// texels.
///
/// A map has two directions, in each of which the two widths are compared along the surface: a
/// pixel is as wide as the ellipse that its round beam becomes on the map. The larger of the two is
/// m.
struct AliasingError
{
  size_t Pixels = 0; // that face the light
  double Maximum = 0;
  double Mean = 0;
  double Percentile95 = 0;
};

/// m of each sample; 0 where it is not defined, behind a spot.
std::vector<double> AliasingErrors(
  const std::vector<ViewSample>& samples, const TexelFunction& texels);

/// What is 0 is left out.
AliasingError Summarize(std::vector<double> errors);
}

#endif
