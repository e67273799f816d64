// SPDX-License-Identifier: BSD-3-Clause
// The storage factor S̄ (Lloyd et al. 2006, sections 4 and 5): how many times the texels of the
// image the shadow maps of a view must have, so that no texel is wider than a pixel anywhere in the
// view's frustum. It goes by perspective aliasing alone, whatever the scene; of directional lights.
#ifndef rtwStorageFactor_h
#define rtwStorageFactor_h

#include <glm/glm.hpp>

namespace rtw
{
/// A view of a square image.
struct StoredView
{
  double Near = 1;
  double Far = 1000;
  double HalfAngle = 0.5235987755982988; ///< θ, in radians: half of its field of view
};

///@{
/// The greatest errors in the frustum for a light overhead, along s and t, of a map and an image of
/// one texel a side each (Equations 9 and 10). n' may be infinite.
double LargestErrorAcross(const StoredView& view, double nearDistance);
double LargestErrorAlong(const StoredView& view, double nearDistance);
///@}

///@{
/// Storage factors in closed form, of k depth partitions whose ends grow geometrically (Equations
/// 15 and 16), for a light overhead or behind the viewer.
double StorageOverhead(const StoredView& view, double nearDistance); ///< one map; Equation 12
double StorageOptimal(const StoredView& view);            ///< the logarithmic map's; appendix C
double StorageOverheadZP(const StoredView& view, int k);  ///< Equation 17
/// Equation 18; and 19, as faces add nothing
double StorageOverheadZPW(const StoredView& view, int k);
double StorageBehindZP(const StoredView& view, int k);    ///< Equation 20, warped or not
double StorageBehindFPZPW(const StoredView& view, int k); ///< Equation 21, in which θ is 45°
///@}

///@{
/// How the storage factor of a light overhead falls with the number of maps where f / n is large,
/// as Equations 22 and 23 compare them: without 1 / (2 tan θ), and with a depth partition for each
/// four maps where there are faces, as there must be with any direction of the light.
double StorageTrendZP(const StoredView& view, int maps);
double StorageTrendFPZPW(const StoredView& view, int maps);
///@}

struct StorageScheme
{
  enum Warps
  {
    None,
    LiSPSM, ///< as vtkPerspectiveShadowMapWarp chooses it: (n + √(n f)) / sin γ
    Best    ///< the n' with the least storage, found by search
  };
  int Warp = None;
  int Partitions = 1; ///< number of depth partitions
  bool Faces =
    /// Whether each face of the frustum that the light sees gets a map, and the near plane one.
    false;
};

struct Storage
{
  double Factor = 0;
  int Maps = 0;
};

/// The storage factor for a directional light, given by the direction in which it travels, in a
/// view along -z with y up: by the widths of image and light beams at the corners of all partitions
/// (section 4.4).
Storage StorageFactor(
  const StoredView& view, const StorageScheme& scheme, const glm::dvec3& direction);
}

#endif
