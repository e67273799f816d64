// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwMakeScenes_h
#define rtwMakeScenes_h

#include "rtwScene.h"

namespace rtw
{
/// A street in a 600 m wide town: houses, picket fences, trees with single leaves.
Scene MakeTown(double scale);

/// Small toys with fine parts in a sand pit; a spot light.
Scene MakeSandbox(double scale);

/// 4000 hairs of 12 segments in front of a wall over a floor; a spot light.
Scene MakeFurball(double scale);

/// Climbing frames, nets and slides of finely tessellated tubes.
Scene MakePlayground(double scale);

/// Duelling frusta: the low light shines straight towards the camera.
Scene MakeDuel(double scale);

/// A block robot by a wall that the light only grazes: projective aliasing.
Scene MakeRobot(double scale);

/// Hills of fractal heights, smooth where the triangles are small, under a low sun.
Scene MakeTerrain(double scale);
}

#endif
