// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwMakeScenes_h
#define rtwMakeScenes_h

#include "rtwScene.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
// Each of these multiplies its triangles by `scale`, roughly, and is at 1 what the comment says.
// What grows is said where it is made: tessellation where surfaces are curved, and numbers, with
// smaller things, where there are many things anyway, so that what is covered, and the picture,
// stay alike.

/// A number of steps of a tessellation at a scale, whose root is given.
inline int Finer(int steps, double root, int least)
{
  return std::max(least, int(std::lround(steps * root)));
}

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

/// A furnished room by night, lit by a lamp over the table, which the camera sees.
Scene MakeRoom(double scale);

/// 1000 actors of about 100 triangles: a machine of plates, bolts, shafts and gears.
Scene MakeAssembly(double scale);

/// A bundle of helices, of imposters, in water, of glyphs.
Scene MakeMolecule(double scale);

/// Hills of fractal heights, smooth where the triangles are small, under a low sun.
Scene MakeTerrain(double scale);
}

#endif
