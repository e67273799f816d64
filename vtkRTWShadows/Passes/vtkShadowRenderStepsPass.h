// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowRenderStepsPass
 * @brief   a whole frame with shadows: opaque, translucent, volumes, overlay, post-processing
 *
 * A vtkRenderStepsPass whose opaque and translucent steps receive the shadows of a vtkShadowMapPass, which the classic
 * chain of baker and pass gives to opaque props alone:
 *
 *     vtkNew<vtkShadowRenderStepsPass> steps;
 *     steps->SetShadowMapPass(shadows);
 *     renderer->SetPass(steps);
 *
 * Each step can be replaced as in the superclass. What a renderer asks for by its flags it gets as without a pass:
 * UseSSAO, UseHiddenLineRemoval, UseDepthPeeling, UseDepthPeelingForVolumes, UseOIT and UseFXAA, with their settings; but
 * hidden lines only where the opaque step, and peeling only where the translucent step wasn't replaced. A selector
 * (vtkHardwareSelector) finds what it would find without a pass.
 */
#ifndef vtkShadowRenderStepsPass_h
#define vtkShadowRenderStepsPass_h

#include "vtkNew.h"              // for ivars
#include "vtkRTWShadowsModule.h" // for the export macro
#include "vtkRenderStepsPass.h"
#include "vtkSmartPointer.h" // for ivars

#include <memory> // for ivars

class vtkSequencePass;
class vtkShadowMapPass;
class vtkShadowedStepPass;

namespace rtw
{
class RendererFlags;
}

class VTKRTWSHADOWS_EXPORT vtkShadowRenderStepsPass : public vtkRenderStepsPass
{
public:
  static vtkShadowRenderStepsPass* New();
  vtkTypeMacro(vtkShadowRenderStepsPass, vtkRenderStepsPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The pass that the shadows come from: a vtkAdaptiveShadowMapPass or one of VTK's own
   * vtkShadowMapPass, which shadows the opaque step only. Null is no shadows. Default: a
   * vtkRTWShadowMapPass.
   */
  virtual void SetShadowMapPass(vtkShadowMapPass* pass);
  virtual vtkShadowMapPass* GetShadowMapPass();
  ///@}

  /**
   * Draws the whole frame.
   */
  void Render(const vtkRenderState* s) override;
  /**
   * Frees the OpenGL objects that were made for that window. The next frame makes new ones.
   */
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkShadowRenderStepsPass();
  ~vtkShadowRenderStepsPass() override;

private:
  vtkShadowRenderStepsPass(const vtkShadowRenderStepsPass&) = delete;
  void operator=(const vtkShadowRenderStepsPass&) = delete;

  vtkRenderPass* MakeOpaqueStep(const vtkRenderState* s);
  vtkRenderPass* MakeTranslucentStep(const vtkRenderState* s);

  vtkSmartPointer<vtkShadowMapPass> ShadowMapPass;
  vtkSmartPointer<vtkRenderPass> OwnOpaque, OwnTranslucent; // those that nobody set
  vtkNew<vtkShadowedStepPass> OpaqueStep;
  vtkNew<vtkShadowedStepPass> TranslucentStep;
  vtkNew<vtkSequencePass> AfterOpaque;
  std::unique_ptr<rtw::RendererFlags> Flags;
};

#endif
