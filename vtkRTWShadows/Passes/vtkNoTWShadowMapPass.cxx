// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoTWShadowMapPass.h"

#include "vtkNonOrthogonalShadowMapWarp.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNoTWShadowMapPass);

vtkNoTWShadowMapPass::vtkNoTWShadowMapPass()
{
  this->SetWarp(this->NonOrthogonal);
}

vtkNoTWShadowMapPass::~vtkNoTWShadowMapPass() = default;

vtkNonOrthogonalShadowMapWarp* vtkNoTWShadowMapPass::GetNonOrthogonalWarp()
{
  return this->NonOrthogonal;
}

void vtkNoTWShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NonOrthogonalWarp: " << this->NonOrthogonal.Get() << "\n";
}
