// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRenderStepsPass.h"

#include "vtkRTWShadowMapPass.h"
#include "vtkShadowedStepPass.h"

#include "vtkDualDepthPeelingPass.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkTranslucentPass.h"

#include <cstring>

vtkStandardNewMacro(vtkShadowRenderStepsPass);

vtkShadowRenderStepsPass::vtkShadowRenderStepsPass()
  : ShadowMapPass(vtkSmartPointer<vtkRTWShadowMapPass>::New())
{
  vtkNew<vtkTranslucentPass> peeled;
  this->DepthPeeling->SetTranslucentPass(peeled);
}

vtkShadowRenderStepsPass::~vtkShadowRenderStepsPass() = default;

void vtkShadowRenderStepsPass::SetShadowMapPass(vtkShadowMapPass* pass)
{
  if (this->ShadowMapPass != pass)
  {
    this->ShadowMapPass = pass;
    this->Modified();
  }
}

vtkShadowMapPass* vtkShadowRenderStepsPass::GetShadowMapPass()
{
  return this->ShadowMapPass;
}

vtkRenderPass* vtkShadowRenderStepsPass::ChooseTranslucentPass(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  const bool replaced = !this->TranslucentPass ||
    std::strcmp(this->TranslucentPass->GetClassName(), "vtkTranslucentPass") != 0;
  if (replaced || !renderer->GetUseDepthPeeling())
  {
    return this->TranslucentPass;
  }
  this->DepthPeeling->SetMaximumNumberOfPeels(renderer->GetMaximumNumberOfPeels());
  this->DepthPeeling->SetOcclusionRatio(renderer->GetOcclusionRatio());
  return this->DepthPeeling;
}

void vtkShadowRenderStepsPass::Render(const vtkRenderState* s)
{
  vtkRenderPass* opaque = this->OpaquePass;
  vtkRenderPass* translucent = this->TranslucentPass;
  // The superclass renders the steps that its members name, so ours stand in for them for that long.
  this->TranslucentPass = this->ChooseTranslucentPass(s);
  if (this->ShadowMapPass && this->OpaquePass)
  {
    this->OpaqueStep->Set(this->ShadowMapPass, this->OpaquePass, true);
    this->OpaquePass = this->OpaqueStep;
  }
  if (this->ShadowMapPass && this->TranslucentPass)
  {
    this->TranslucentStep->Set(this->ShadowMapPass, this->TranslucentPass, !opaque);
    this->TranslucentPass = this->TranslucentStep;
  }
  this->Superclass::Render(s);
  this->OpaquePass = opaque;
  this->TranslucentPass = translucent;
  this->OpaqueStep->Set(nullptr, nullptr, false);
  this->TranslucentStep->Set(nullptr, nullptr, false);
}

void vtkShadowRenderStepsPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Superclass::ReleaseGraphicsResources(w);
  this->DepthPeeling->ReleaseGraphicsResources(w);
  if (this->ShadowMapPass)
  {
    // VTK's own pass releases only its baker, and only there its maps.
    this->ShadowMapPass->ReleaseGraphicsResources(w);
    if (vtkShadowMapBakerPass* baker = this->ShadowMapPass->GetShadowMapBakerPass())
    {
      baker->ReleaseGraphicsResources(w);
    }
  }
}

void vtkShadowRenderStepsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShadowMapPass: " << this->ShadowMapPass.Get() << "\n";
}
