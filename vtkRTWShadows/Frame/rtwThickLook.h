// SPDX-License-Identifier: BSD-3-Clause
// How an actor draws lines and points, whose width is so many pixels of the window, whatever they stand for in the world.
#ifndef rtwThickLook_h
#define rtwThickLook_h

namespace rtw
{
struct ThickLook
{
  enum class Shape
  {
    Surface, ///< triangles, and what lines and vertices the mesh has
    Edges,   ///< the edges of all cells, and the mesh's vertices
    Points   ///< the points of all cells
  };

  Shape Drawn = Shape::Surface;
  bool AllPoints = false; ///< whether the points of all cells are drawn as well, whatever else is
  double LineWidth = 1;   ///< pixels
  double PointSize = 1;
};
}

#endif
