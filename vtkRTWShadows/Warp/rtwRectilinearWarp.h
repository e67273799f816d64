// SPDX-License-Identifier: BSD-3-Clause
// The double-precision twin of the rectilinear warp in rtwWarpRectilinear.glsl and rtwBuildRectilinear.glsl, with its inverse.
#ifndef rtwRectilinearWarp_h
#define rtwRectilinearWarp_h

#include "rtwLightFrame.h"

#include <glm/glm.hpp>

#include <vector>

namespace rtw
{
/// A strictly monotone map of [0, 1] to itself, linear in each of its equal cells, and beyond the ends with the slope there.
class WarpingFunction
{
public:
  /// From the importance of each cell: blurred by a Gaussian of so many cells, kept above a share of the mean, summed up
  /// and normalized (Rosen 2012, section 4.2, equation 1). No or no finite importance gives the identity.
  static WarpingFunction FromImportance(std::vector<double> importance, double sigma, double floor);
  /// From its values at the borders of the cells, which rise from 0 to 1.
  static WarpingFunction FromValues(std::vector<double> values);

  int GetCells() const { return static_cast<int>(this->Values.size()) - 1; }
  const std::vector<double>& GetValues() const { return this->Values; }
  double Forward(double x) const;
  double Inverse(double y) const;
  double Slope(int cell) const;
  double GreatestSlope() const;
  /// No point between low and high is mapped farther from the chord between the two than that.
  double Bend(double low, double high) const;

private:
  std::vector<double> Values{ 0, 1 };
};

/// RTW: one warping function for s, one for t, over a focus on the light plane.
struct RectilinearWarp
{
  Rectangle Focus;
  WarpingFunction S, T;

  glm::dvec2 ToFocused(const glm::dvec2& onLight) const;
  glm::dvec2 Forward(const glm::dvec2& onLight) const;
  glm::dvec2 Inverse(const glm::dvec2& onMap) const;
  /// The conventional map over `whole` that is as fine as this one is at its finest: maximum effective
  /// resolution (Rosen 2012, section 6).
  glm::dvec2 MaximumEffectiveResolution(int resolution, const Rectangle& whole) const;
};
}

#endif
