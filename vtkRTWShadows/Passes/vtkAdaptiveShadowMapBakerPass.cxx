// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveShadowMapBakerPass.h"

#include "vtkAdaptiveShadowMapPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAdaptiveShadowMapBakerPass);

vtkAdaptiveShadowMapBakerPass::vtkAdaptiveShadowMapBakerPass()
{
  this->Resolution = 1024;
}

vtkAdaptiveShadowMapBakerPass::~vtkAdaptiveShadowMapBakerPass() = default;

void vtkAdaptiveShadowMapBakerPass::SetResolution(unsigned int resolution)
{
  if (resolution == 0)
  {
    vtkErrorMacro(
      "SetResolution(0): expected at least 1 texel a side; keeping " << this->Resolution);
    return;
  }
  if (this->Resolution != resolution)
  {
    this->Resolution = resolution;
    this->Modified();
  }
}

void vtkAdaptiveShadowMapBakerPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  this->HasShadows = false;
  if (!this->ShadowMapPass)
  {
    if (!this->Warned)
    {
      this->Warned = true;
      vtkWarningMacro("has no vtkAdaptiveShadowMapPass and bakes nothing; use the baker that "
                      "GetShadowMapBakerPass() of that pass gives");
    }
    return;
  }
  this->ShadowMapPass->Bake(s);
  this->HasShadows = this->ShadowMapPass->GetNumberOfShadowLights() > 0;
  this->NeedUpdate = this->ShadowMapPass->GetNumberOfLayersDrawn() > 0;
  if (this->NeedUpdate)
  {
    this->LastRenderTime.Modified();
  }
}

void vtkAdaptiveShadowMapBakerPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->HasShadows = false;
  if (this->ShadowMapPass)
  {
    this->ShadowMapPass->ReleaseGraphicsResources(w);
  }
}

void vtkAdaptiveShadowMapBakerPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShadowMapPass: " << this->ShadowMapPass.GetPointer() << "\n";
}
