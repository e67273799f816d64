// SPDX-License-Identifier: BSD-3-Clause
// The double-precision twin of the non-orthogonal warp in rtwWarpNonOrthogonal.glsl and of the
// shaders that build it, with its inverse.
#ifndef rtwNonOrthogonalWarp_h
#define rtwNonOrthogonalWarp_h

#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include <glm/glm.hpp>

#include <vector>

namespace rtw
{
/// Constants of the choice of smoothing, and the coarse grid that it is made on.
struct SmoothingChoice
{
  static constexpr int Cells = 64;
  static constexpr int Candidates = 11;   ///< each times √2 the one before
  static constexpr double Least = 0.0125; ///< σ as a share of the focus
  /// How far a texel's side is sheared, as a share of its length, where a function rises as fast
  /// across, from line to line, as along on average.
  static constexpr double Shear = 0.5;
  /// Additional error, as a share, where an edge that is drawn straight strays by a texel.
  static constexpr double StrayCost = 1;
  static constexpr double Range = 0.003; ///< of cost, in which candidates count together
  /// The cost per second derivative of a function across lines, given the length of edges that are
  /// drawn straight and the number of texels a side.
  static double BendCost(double straight, int resolution)
  {
    return StrayCost * straight * straight / 8 * resolution;
  }
};

/// A function of one coordinate, `along`, that is a WarpingFunction on each of so many lines and
/// changes linearly from the middle of one to that of the next in the other, `across`. Outside [0,
/// 1] it is no warp.
class WarpingGrid
{
public:
  /// The grid for what each line's cells ask for, line by line: averaged over neighbouring lines
  /// with a Gaussian of so many lines, or nearly that (Milet et al. 2015, step 5); the root is
  /// taken where it is demand; then each line by WarpingFunction::FromImportance().
  static WarpingGrid FromImportance(
    std::vector<std::vector<double>> lines, double across, bool root, double sigma, double floor);
  /// The share of all lines that FromImportance() had better average over: the one that the least
  /// error is predicted for.
  static double ChooseSmoothing(
    const std::vector<std::vector<double>>& lines, bool root, double floor, double bendCost);
  static WarpingGrid FromFunctions(std::vector<WarpingFunction> lines);

  double Forward(double along, double across) const;
  double Inverse(double value, double across) const;
  const std::vector<WarpingFunction>& GetLines() const { return this->Lines; }

private:
  struct Between
  {
    int Line;     ///< and the next
    double Share; ///< of that
  };
  Between LinesAt(double across) const;
  double AtBorder(const Between& between, int border) const;

  std::vector<WarpingFunction> Lines{ WarpingFunction(), WarpingFunction() };
};

/// NoTW: a function along s for each row, then one along t for each column of the result (Milet et
/// al. 2015, equation 6, but continuous).
struct NonOrthogonalWarp
{
  Rectangle Focus;
  WarpingGrid Rows, Columns;

  glm::dvec2 Forward(const glm::dvec2& onLight) const;
  glm::dvec2 Inverse(const glm::dvec2& onMap) const;
};
}

#endif
