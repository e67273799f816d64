// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapPartition.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShadowMapPartition);

vtkShadowMapPartition::vtkShadowMapPartition() = default;
vtkShadowMapPartition::~vtkShadowMapPartition() = default;

void vtkShadowMapPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLayers: " << this->GetNumberOfLayers() << "\n";
}
