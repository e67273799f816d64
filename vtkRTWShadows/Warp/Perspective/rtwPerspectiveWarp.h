// SPDX-License-Identifier: BSD-3-Clause
// Perspective warps by the distance n' of their centre of projection from the view's near end
// (Lloyd et al. 2006, section 4.1), and the double-precision twin, with its inverse, of
// rtwWarpPerspective.glsl and of the shader that chooses it.
#ifndef rtwPerspectiveWarp_h
#define rtwPerspectiveWarp_h

#include "Light/rtwLightFrame.h"

#include <glm/glm.hpp>

namespace rtw
{
/// How n' is given.
struct PerspectiveChoice
{
  enum Kinds
  {
    Eta,       ///< Equation 11
    Near,      ///< n' itself, in world units
    FocusPoint ///< its distance from the near end, as a share of what is seen along the view, is on
               ///< the focus line: trapezoidal shadow maps
  };
  int Kind = Eta; ///< one of Kinds, numbered as rtwChoice of rtwBuildPerspective.glsl
  double Value = 0;
};

/// n' of η from -1 (infinite: no warp) over 0 (LiSPSM: n + √(f n)) to 1 (PSM: n); Equation 11.
double NearOfEta(double eta, double n, double f);
/// η of n', the inverse of NearOfEta() (appendix B).
double EtaOfNear(double nearDistance, double n, double f);
/// The n' that puts the focus point, which lies a share of f - n behind n, on the line before which
/// 80 % of the map lie: at least n, and infinite where an unwarped map has it there already.
double NearOfFocusPoint(double share, double n, double f);
/// 1 / n' for a light overhead, from 0 (no warp) to 1 / n.
double InverseOfNear(const PerspectiveChoice& choice, double n, double f);

/// How a light sees the view.
struct ViewOnLight
{
  double Sine = 0; ///< sine of the angle between view and light
  double Unit = 0; ///< world units that one of the light plane is at the eye; 0 where it shows no
                   ///< perspective
  double EyeS = 0; ///< s of the line on the light plane that all lines along the view meet on
};

/// The view as a light sees it, with t along the view. Unit is 0 for a parallel view, which has no
/// perspective, and for an eye behind a spot.
ViewOnLight LookAtView(
  const LightFrame& frame, const glm::dvec3& eye, const glm::dvec3& forward, bool parallel);

/// A layer's warp of its focus.
struct PerspectiveWarp
{
  Rectangle Focus;
  double Strength = 0;     ///< (f' - n') / n'; 0 for no warp
  double EyeS = 0.5;       ///< on the focus
  glm::dvec2 Ends{ 0, 1 }; ///< ends of the map along s, in focus coordinates, where t is 0

  /// Map coordinates of a point in light-plane coordinates; not a number behind the centre of
  /// projection.
  glm::dvec2 Forward(const glm::dvec2& onLight) const;
  glm::dvec2 Inverse(const glm::dvec2& onMap) const;
};

/// (f' - n') / n' for a focus of that extent along t, in light-plane units, whose nearest sample is
/// so far from the viewer: n' is that of a light overhead over the sine between view and light
/// (Wimmer et al. 2004), f what the extent amounts to along the view.
double PerspectiveStrength(
  const PerspectiveChoice& choice, const ViewOnLight& view, double nearest, double extent);
}

#endif
