// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRenderStepsPass.h"

#include "Frame/rtwView.h"
#include "Passes/rtwRendererFlags.h"
#include "Passes/rtwSelection.h"

#include "Passes/vtkShadowedStepPass.h"
#include "vtkRTWShadowMapPass.h"

#include "vtkObjectFactory.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"

vtkStandardNewMacro(vtkShadowRenderStepsPass);

vtkShadowRenderStepsPass::vtkShadowRenderStepsPass()
  : ShadowMapPass(vtkSmartPointer<vtkRTWShadowMapPass>::New())
  , Flags(new rtw::RendererFlags)
{
  vtkNew<vtkRenderPassCollection> passes;
  this->AfterOpaque->SetPasses(passes);
  this->OwnOpaque = this->OpaquePass;
  this->OwnTranslucent = this->TranslucentPass;
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

// The opaque step; null for none.
vtkRenderPass* vtkShadowRenderStepsPass::MakeOpaqueStep(const vtkRenderState* s)
{
  // One that somebody set is drawn as it is, as VTK's own steps do.
  vtkRenderPass* drawn = this->OpaquePass;
  drawn = drawn == this->OwnOpaque ? this->Flags->DrawOpaque(s, drawn) : drawn;
  if (drawn && this->ShadowMapPass)
  {
    this->OpaqueStep->Set(this->ShadowMapPass, drawn, true);
    drawn = this->OpaqueStep;
  }
  return this->Flags->AroundOpaque(s, drawn);
}

// The translucent step with what comes between it and volumes; null for none.
vtkRenderPass* vtkShadowRenderStepsPass::MakeTranslucentStep(const vtkRenderState* s)
{
  vtkRenderPass* drawn = this->TranslucentPass;
  if (drawn == this->OwnTranslucent)
  {
    drawn = this->Flags->DrawTranslucent(s, drawn, this->VolumetricPass);
  }
  if (drawn && this->ShadowMapPass)
  {
    this->TranslucentStep->Set(this->ShadowMapPass, drawn, !this->OpaquePass);
    drawn = this->TranslucentStep;
  }
  vtkRenderPass* after = this->Flags->AfterTranslucent(s);
  if (!drawn || !after)
  {
    return drawn ? drawn : after;
  }
  this->AfterOpaque->GetPasses()->AddItem(drawn);
  this->AfterOpaque->GetPasses()->AddItem(after);
  return this->AfterOpaque;
}

void vtkShadowRenderStepsPass::Render(const vtkRenderState* s)
{
  if (rtw::RenderSelection(s))
  {
    return;
  }
  rtw::FollowStereo(s->GetRenderer());
  this->Flags->Begin(s);
  vtkRenderPass* opaqueStep = this->MakeOpaqueStep(s);
  vtkRenderPass* translucentStep = this->MakeTranslucentStep(s);
  vtkRenderPass* opaque = this->OpaquePass;
  vtkRenderPass* translucent = this->TranslucentPass;
  vtkRenderPass* volumetric = this->VolumetricPass;
  // The superclass renders the steps that its members name, so ours stand in for them for that long.
  this->OpaquePass = opaqueStep;
  this->TranslucentPass = translucentStep;
  this->VolumetricPass = this->Flags->PeelsVolumes() ? nullptr : volumetric;
  this->Superclass::Render(s);
  this->OpaquePass = opaque;
  this->TranslucentPass = translucent;
  this->VolumetricPass = volumetric;
  this->AfterOpaque->GetPasses()->RemoveAllItems();
  this->OpaqueStep->Set(nullptr, nullptr, false);
  this->TranslucentStep->Set(nullptr, nullptr, false);
}

void vtkShadowRenderStepsPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Superclass::ReleaseGraphicsResources(w);
  this->Flags->ReleaseGraphicsResources(w);
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
