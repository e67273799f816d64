// SPDX-License-Identifier: BSD-3-Clause
// Where a view's coordinates begin, and what its samples hold: in pure functions.
//
// A sample holds one over the distance along the view, or in a framed view, of which an eye says nothing or little, what is left of
// depth: 1 at the near end of what is seen, 0 at the far. Both are linear on the screen.
#ifndef rtwFramedView_h
#define rtwFramedView_h

#include "Frame/rtwView.h"

namespace rtw
{
/// The view, framed where that makes it more precise, for all that is seen lies between two distances
/// from the camera along the view. Its near and far plane cut as the camera's do.
View Framed(const View& view, const glm::dvec2& seen);
/// The view in coordinates that begin at the eye, whatever is seen.
View AtEye(const View& view);

/// Where the eye is in view coordinates: in stereo beside the camera. In a parallel view the way towards
/// it, one unit of distance long.
glm::dvec3 SeenFrom(const View& view);

/// How the picture's window-space depth becomes what a sample holds: scale and offset.
glm::dvec2 DepthToSample(const View& view);
/// The same for the depth of what is drawn into the samples' target.
glm::dvec2 OwnDepthToSample(const View& view);
/// The scale and offset from clip to view coordinates, before the division.
glm::dvec4 RayOf(const View& view);
/// What a sample adds to x and y of view coordinates, times the sample, where the eye is beside the
/// camera.
glm::dvec2 ShearOf(const View& view);
/// The coefficients that take a sample a to view coordinates: z is (x + y a) / (z + w a), and all
/// are divided by the latter.
glm::dvec4 PlaceOf(const View& view);
/// The step from pixel to pixel in view coordinates at distance 1 (anywhere in a parallel view),
/// and what a sample changes by with one over the distance, or in a parallel view with z.
glm::dvec3 RayStep(const View& view);
}

#endif
