// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/vtkShadowedStepPass.h"

#include "vtkAdaptiveShadowMapPass.h"

#include "vtkObjectFactory.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

vtkStandardNewMacro(vtkShadowedStepPass);

vtkShadowedStepPass::vtkShadowedStepPass() = default;
vtkShadowedStepPass::~vtkShadowedStepPass() = default;

void vtkShadowedStepPass::Set(vtkShadowMapPass* shadows, vtkRenderPass* delegate, bool bake)
{
  this->Shadows = shadows;
  this->Delegate = delegate;
  this->Bake = bake;
}

void vtkShadowedStepPass::Render(const vtkRenderState* s)
{
  vtkRenderPass* drawn = this->Delegate;
  if (this->Bake && this->Shadows->GetShadowMapBakerPass())
  {
    this->Shadows->GetShadowMapBakerPass()->Render(s);
  }
  if (auto* adaptive = vtkAdaptiveShadowMapPass::SafeDownCast(this->Shadows))
  {
    adaptive->RenderShadowed(s, this->Delegate);
  }
  else
  {
    // VTK's own pass draws with an opaque sequence of its own.
    drawn = this->Bake ? this->Shadows : this->Delegate;
    drawn->Render(s);
  }
  this->NumberOfRenderedProps = drawn->GetNumberOfRenderedProps();
}
