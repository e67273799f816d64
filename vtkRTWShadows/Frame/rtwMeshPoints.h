// SPDX-License-Identifier: BSD-3-Clause
// What all readers of meshes begin with: their points as floats that are precise wherever the mesh
// lies, and their cells one after another.
#ifndef rtwMeshPoints_h
#define rtwMeshPoints_h

#include <glm/glm.hpp>

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace rtw
{
struct MeshPoints
{
  glm::dvec3 Centre{ 0 };        ///< what was taken off each point before it became a float
  std::vector<glm::vec3> Points; ///< in the order of the input

  /// Whether there is such a point, and it is finite.
  bool Exists(vtkIdType id) const;
};

MeshPoints ReadPoints(vtkPolyData* data);

/// Gives each cell's number of points and their numbers to `visit`; nothing where there is no
/// array.
template <class Visit>
void ForEachCell(vtkCellArray* cells, Visit visit)
{
  if (!cells)
  {
    return;
  }
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* ids;
    cell->GetCurrentCell(count, ids);
    visit(count, ids);
  }
}
}

#endif
