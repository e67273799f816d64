// SPDX-License-Identifier: BSD-3-Clause
// The double-precision twin of the non-orthogonal warp in rtwWarpNonOrthogonal.glsl and of the
// shaders that build it, with its inverse.
#ifndef rtwNonOrthogonalWarp_h
#define rtwNonOrthogonalWarp_h

#include "rtwRectilinearWarp.h"

#include <glm/glm.hpp>

#include <vector>

namespace rtw
{
/// A function of one coordinate, `along`, that is a WarpingFunction on each of so many lines and
/// changes linearly from the middle of one to that of the next in the other, `across`. Outside [0,
/// 1] it is no warp.
class WarpingGrid
{
public:
  /// From what each line's cells ask for, line by line: averaged over neighbouring lines with a
  /// Gaussian of so many lines, or nearly that (Milet et al. 2015, step 5); the root is taken where
  /// it is demand; then each line by WarpingFunction::FromImportance().
  static WarpingGrid FromImportance(
    std::vector<std::vector<double>> lines, double across, bool root, double sigma, double floor);
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
