// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapPartition.h"

#include "Partition/rtwPartitionStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShadowMapPartition);

vtkShadowMapPartition::vtkShadowMapPartition() = default;
vtkShadowMapPartition::~vtkShadowMapPartition() = default;

std::unique_ptr<rtw::PartitionStage> vtkShadowMapPartition::MakeStage()
{
  return std::make_unique<rtw::WholeViewStage>();
}

void vtkShadowMapPartition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLayers: " << this->GetNumberOfLayers() << "\n";
}
