// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUniformShadowMapPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkUniformShadowMapPass);

vtkUniformShadowMapPass::vtkUniformShadowMapPass() = default;
vtkUniformShadowMapPass::~vtkUniformShadowMapPass() = default;

void vtkUniformShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
