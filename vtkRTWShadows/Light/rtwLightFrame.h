// SPDX-License-Identifier: BSD-3-Clause
// A light's view of the world, in double precision: where a point lies on the light plane, and how deep.
//
// Light-plane coordinates l have their origin where view coordinates do, at the viewer's eye or at what that sees from afar, so that
// they are precise near it when they become floats: across a directional light in world units, across a spot as the tangents of
// angles. Depth is linear in l over any plane (for a spot it goes with the inverse distance along the axis), 0 at the near end of the
// scene, 1 at the far.
#ifndef rtwLightFrame_h
#define rtwLightFrame_h

#include "Light/rtwRectangle.h"

#include <glm/glm.hpp>

#include <functional>

namespace rtw
{
enum class LightKind
{
  Directional,
  Spot
};

/// A light as it stands in the world in this frame.
struct ShadowLight
{
  LightKind Kind = LightKind::Directional;
  int Switched = 0; ///< its number among the lights that are switched on: N of VTK's lightColorN
  glm::dvec3 Direction{ 0, 0, -1 }; ///< in which light travels, or the spot's axis; unit
  glm::dvec3 Position{ 0 };         ///< place of a spot
  double ConeAngle = 0;             ///< half of a spot's opening, in degrees
  double Attenuation = 1;           ///< how much of the light a shadow takes away, 0 to 1

  /// Where light comes from: the place of a spot, or, w being 0, the way there.
  glm::dvec4 GetOrigin() const;
  bool operator==(const ShadowLight& other) const;
};

struct LightFrame
{
  ShadowLight Light;
  glm::dvec3 SAxis{ 1, 0, 0 };
  glm::dvec3 TAxis{ 0, 1, 0 };
  /// The matrix from world coordinates to (l · w, depth · w, w); w is 1 for a directional light,
  /// the distance along the axis for a spot.
  glm::dmat4 WorldToLight{ 1 };
  Rectangle Bounds;         ///< a square on the light plane that holds the scene, or a spot's cone
  glm::dvec2 ConeCentre{ 0 }; ///< centre of a spot's cone on the light plane
  double ConeTangent = 0;
  double NearestDistance = 0; ///< along a spot's axis, where depth is 0
  double FarthestDistance = 0; ///< along a spot's axis, where depth is 1
  double DepthRange = 1;    ///< world units of depth at a directional light
  int Parts = 1;            ///< layers that share the light's samples, one after another
  /// Sides of the view frustum that each range of depths is divided among: 4, or 1 for none.
  int Faces = 1;
  int Layer = 0; ///< number of the layer that the frame is for

  /// Number of the light among those with a map.
  int Number() const { return this->Layer / this->Parts; }

  /// The depth that a world length of 1 along the light amounts to; for a spot, times w².
  double DepthOfLength() const;
  /// WorldToLight, but with light-plane coordinates that go from 0 to 1 over a focus.
  glm::dmat4 WorldToFocus(const Rectangle& focus) const;
  /// Light-plane coordinates and depth; infinite behind a spot.
  glm::dvec3 Project(const glm::dvec3& world) const;
};

/// The least and the greatest product of a direction with any point of what a light shines on.
using ExtentFunction = std::function<glm::dvec2(const glm::dvec3& direction)>;

/// A frame for a light, seen from the eye, or from where view coordinates begin. `turn`, in radians about the light's direction, is that of
/// its axes from where they lie by themselves.
LightFrame MakeLightFrame(const ShadowLight& light, const ExtentFunction& extent,
  const glm::dvec3& eye, double turn = 0);

/// The frame with its axes turned by an angle in radians. Bounds of a directional light become the
/// square that holds the old ones.
LightFrame Turned(const LightFrame& frame, double by);

/// Half a degree between view and light: any less, and a slight move of the camera would turn the
/// light plane far.
constexpr double LeastShownAlong = 0.01;

/// The turn that lays the t axis along the image that the light has of the line from the eye
/// forward; 0 where that is a point, as good as: no longer than `least` of it.
double ViewAlignedTurn(const ShadowLight& light, const glm::dvec3& eye, const glm::dvec3& forward,
  double least = LeastShownAlong);
}

#endif
