// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCollect.h"
#include "rtwCompositeMapper.h"

#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSetMapper.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

namespace rtw
{
namespace
{
// A block is visible as its nearest ancestor that says so.
void AddVisible(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, bool visible,
  std::vector<vtkPolyData*>& surfaces)
{
  if (attributes && attributes->HasBlockVisibility(data))
  {
    visible = attributes->GetBlockVisibility(data);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    const auto each = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    each->TraverseSubTreeOff();
    each->VisitOnlyLeavesOff();
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      AddVisible(each->GetCurrentDataObject(), attributes, visible, surfaces);
    }
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (surface && visible && surface->GetPoints())
  {
    surfaces.push_back(surface);
  }
}
}

std::vector<vtkPolyData*> Surfaces(vtkMapper* mapper)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  auto* others = vtkDataSetMapper::SafeDownCast(mapper);
  if (others && others->GetPolyDataMapper())
  {
    data = others->GetPolyDataMapper()->GetInputDataObject(0, 0);
  }
  auto* composite = CompositeMapper::SafeDownCast(mapper);
  std::vector<vtkPolyData*> surfaces;
  if (data)
  {
    AddVisible(
      data, composite ? composite->GetCompositeDataDisplayAttributes() : nullptr, true, surfaces);
  }
  return surfaces;
}
}
