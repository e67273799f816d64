// SPDX-License-Identifier: BSD-3-Clause
// How the texels of a perspective warp's maps are divided between s and t (Lloyd et al. 2006,
// section 4.2): by what the view's frustum shows of the scene, on the CPU, so that it is known
// before anything is drawn.
#ifndef rtwResolutionSplit_h
#define rtwResolutionSplit_h

#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace rtw
{
struct View;

/// Texels along s and t of a map of so many in all, whose largest errors along them are Ms and Mt
/// at one texel a side each: in their ratio, so that the errors become equal (Equations 13 and 14).
glm::dvec2 SplitResolution(double texels, double ms, double mt);

/// Whole texels along s and t, no more than those of a square of that side, in about that ratio;
/// closer to the square where one would be more than `most`. The square itself for a ratio of 1.
glm::ivec2 SplitTexels(int side, double ratio, int most);

/// What the maps of a frame are for.
struct SplitScene
{
  const std::vector<LightFrame>& Frames; ///< one frame for each layer
  const View& Viewed;
  glm::dvec3 Low{ 0 }, High{ 0 }; ///< bounds of the scene in world coordinates
  const void* Viewer = nullptr;   ///< who looks, only compared with others
  bool Focused = true;            ///< whether maps go by the view
};

/// Greatest errors along s and t in a part of the view's frustum, given by its corners, of a map of
/// one texel a side that is fitted to it; 0 where the light reaches none. Those of Equations 9 and
/// 10 in any direction of the light: the greatest are at corners, since widths of beams are convex.
glm::dvec2 LargestErrors(const PerspectiveChoice& choice, const LightFrame& frame,
  const View& viewed, const std::vector<glm::dvec3>& corners);

/// Texels along s over those along t at which the errors are equal: of several layers, whose maps
/// have one size, the geometric mean. Layers by depth count as if their depths grew evenly.
double CriticalRatio(const PerspectiveChoice& choice, const SplitScene& scene);

/// Ratios that are compared by predicted errors: powers of the root that SteadyRatio has, up to so
/// many, either way.
constexpr int SplitSteps = 10;

/// The exponent of the ratio with the least error, or the one in force, if any is, where none is
/// clearly better. Each viewer gives, for each ratio from the lowest on, by how many pixels all
/// edges together are misplaced; where there are next to no edges, the exponent is about 0.
int LeastErrorStep(
  const std::vector<std::vector<float>>& errors, const std::optional<int>& inForce);

/// A ratio that is one of a few and stays as it is until another would clearly be better, so that
/// textures last and nothing pops while a camera moves.
class SteadyRatio
{
public:
  static constexpr int StepsAnOctave = 4;
  /// The ratio for a viewer who wants that one; if several viewers draw alternately, the geometric
  /// mean of what they want.
  double Choose(const void* viewer, double wanted);
  void Forget();

private:
  struct Wish
  {
    double Steps;
    std::int64_t Time;
  };
  std::map<const void*, Wish> Wishes;
  std::int64_t Time = 0;
  int Step = 0;
  bool Held = false;
};
}

#endif
