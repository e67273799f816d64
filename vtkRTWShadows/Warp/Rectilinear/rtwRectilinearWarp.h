// SPDX-License-Identifier: BSD-3-Clause
// The double-precision twin of the rectilinear warp in rtwWarpRectilinear.glsl and
// rtwBuildRectilinear.glsl, with its inverse.
#ifndef rtwRectilinearWarp_h
#define rtwRectilinearWarp_h

#include "Light/rtwLightFrame.h"

#include <glm/glm.hpp>

#include <vector>

namespace rtw
{
/// What keeps sums strictly monotone in single precision: the least share of the map that any cell
/// gets, sixteen times what a sum near 1 is rounded by.
constexpr double LeastShare = 1.0 / (1 << 20);
/// How many texels around a receiver the narrowest filter may look at.
constexpr double NeighbourReach = 2;

/// How much larger a snapped focus is than it has to be, on either side, as a share of its extent.
constexpr double SnappingMargin = 0.03125;
/// How much larger a snapped focus becomes than it has to be where it is outgrown.
constexpr double SnappingGrowth = 0.125;
/// The share of a snapped focus that has to be needed for it to stay.
constexpr double SnappingLeastShare = 0.25;
/// A snapped function stays while its error is above the least by so much at most.
constexpr double SnappingMostExcess = 0.1;

/// Number of frames until a function that keeps the share `blending` of the last frame's is within
/// a quarter of a texel of the one wanted, if that stays the same.
int FramesToSettle(double blending, int resolution);

/// A strictly monotone map of [0, 1] to itself, linear in each of its equal cells, and beyond the
/// ends with the slope there.
class WarpingFunction
{
public:
  /// The function for the importance of each cell: blurred by a Gaussian of so many cells, kept
  /// above a share of the mean, summed up and normalized (Rosen 2012, section 4.2, equation 1). No
  /// or no finite importance gives the identity. With `used` cells are culled as by Culled().
  static WarpingFunction FromImportance(std::vector<double> importance, double sigma, double floor,
    const std::vector<bool>& used = {}, double reach = 0);
  /// The function with those values at the borders of its cells, which rise from 0 to 1.
  static WarpingFunction FromValues(std::vector<double> values);

  /// This function, but cells that are not in use get no more than LeastShare: `used` tells it of
  /// each of so many equal parts; none is all. Kept are cells as near to one in use as the blur
  /// reaches, or as that share of the map.
  WarpingFunction Culled(const std::vector<bool>& used, double sigma, double reach) const;
  /// A convex combination with the last frame's function, which has the share given; 0 and 1 of
  /// this function's domain lie at `from` and `to` of the last one's.
  WarpingFunction BlendedWith(
    const WarpingFunction& last, double from, double to, double share) const;
  /// How much greater the error of this function is than that of another, where that one is the
  /// best (its density is the root of demand): a shadow's edge where it wants p texels and gets k
  /// is off by p²/k.
  double ExcessOver(const WarpingFunction& best) const;
  /// The function to use where this one is wanted and the last frame's was `last`: `last` as long
  /// as it is good enough.
  WarpingFunction SnappedTo(const WarpingFunction& last) const;

  int GetCells() const { return static_cast<int>(this->Values.size()) - 1; }
  const std::vector<double>& GetValues() const { return this->Values; }
  double Forward(double x) const;
  double Inverse(double y) const;
  double Slope(int cell) const;
  double GreatestSlope() const;
  /// The greatest distance from the chord between low and high at which any point between them is
  /// mapped.
  double Bend(double low, double high) const;

private:
  static WarpingFunction FromWidths(const std::vector<double>& widths);
  double WidthOf(int cell) const;
  bool IsNeeded(int cell, const std::vector<bool>& used, int radius, double reach) const;

  std::vector<double> Values{ 0, 1 };
};

/// Where a focus along one axis begins and ends, if it has to hold `needed`, and was `last` in the
/// last frame; null if nothing is known of that.
glm::dvec2 SnappedEnds(const glm::dvec2& needed, const glm::dvec2* last);

/// RTW: one warping function for s, one for t, over a focus on the light plane.
struct RectilinearWarp
{
  Rectangle Focus;
  WarpingFunction S, T;

  glm::dvec2 ToFocused(const glm::dvec2& onLight) const;
  glm::dvec2 Forward(const glm::dvec2& onLight) const;
  glm::dvec2 Inverse(const glm::dvec2& onMap) const;
  /// The conventional map over `whole` that is as fine as this one is at its finest: maximum
  /// effective resolution (Rosen 2012, section 6).
  glm::dvec2 MaximumEffectiveResolution(int resolution, const Rectangle& whole) const;
};
}

#endif
