// SPDX-License-Identifier: BSD-3-Clause
// Which turns of a light's plane are compared, by what, and when another is taken.
#ifndef rtwTurnChoice_h
#define rtwTurnChoice_h

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace rtw
{
/// The turns that are compared by error, in radians: first the one in force, then all that differ
/// on a map of columns and rows, 11.25 degrees apart, then the one along the view.
std::vector<double> TurnCandidates(double inForce, double viewAligned);

/// The index of the least error, if that is a tenth less than the first; else 0.
std::size_t BestTurn(const std::vector<float>& errors);

/// The turns that are compared by area, in radians: first the one in force, then 0, then all that
/// differ on a rectangle, 2.8 degrees apart, then that of the minimal frustum.
std::vector<double> AreaCandidates(double inForce, double minimal);

/// The index of the least area, if that is a tenth less than the first; else 1, no turn, where that
/// has less than the first, so that a turn never takes more than none; else 0.
std::size_t LeastTurn(const std::vector<float>& areas);

/// A view sample on the light plane.
struct TurnSample
{
  glm::dvec2 Place;
  /// Steps on the light plane to where the next pixels show its tangent plane.
  glm::dvec2 ToRight, ToAbove;
  bool AtEdge = true;          ///< whether it is beside a shadow edge
  glm::dvec2 Normal{ 0 };      ///< across that edge, on the screen, of length 1; 0 if not known
};

/// The twin of rtwMisplaced in rtwShadowEdge.glsl, kept below the most that an edge can be
/// misplaced.
double Misplacement(const TurnSample& sample, const glm::dvec2& off);

/// The twin of rtwTurnErrors.glsl: pixels by which shadow edges move when a map of so many texels a
/// side is a texel off, summed over all samples. Of a map that adapts the density is the square
/// root of demand, so that where all is an edge the sum is the demand's least error, (∫√d)² a texel
/// (Rosen 2012, equation 1, solved for the least sum of texels over pixels).
double TurnError(const std::vector<TurnSample>& samples, double turn, int texels, bool adapts);
}

#endif
