// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwCollect_h
#define rtwCollect_h

#include "rtwGeometry.h"
#include "rtwReference.h"

class vtkGlyph3DMapper;
class vtkMapper;
class vtkPolyData;
class vtkRenderer;

namespace rtw
{
/// An affine map from model coordinates to those of Geometry.
struct Placement
{
  glm::dmat3 Linear{ 1 };
  dvec3 Offset{ 0 };

  dvec3 operator()(const double p[3]) const
  {
    return this->Linear * dvec3(p[0], p[1], p[2]) + this->Offset;
  }
};

/// Everything visible in a renderer.
Geometry Collect(vtkRenderer* renderer, const ReferenceOptions& options);

/// The parts of it. `prop` is the index of the traits.
void AddSurface(vtkPolyData* surface, const Placement& placement, uint32_t prop, Geometry& to);
void AddGlyphs(vtkGlyph3DMapper* glyphs, const Placement& placement, uint32_t prop, Geometry& to);

/// The spheres and sticks that some mappers draw in place of points; false for other mappers.
bool AddImposters(vtkMapper* mapper, const Placement& placement, uint32_t prop, Geometry& to);

/// The polygonal data sets that a mapper draws: its input, or the visible ones of a composite
/// input.
std::vector<vtkPolyData*> Surfaces(vtkMapper* mapper);
}

#endif
