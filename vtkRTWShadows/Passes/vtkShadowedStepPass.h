// SPDX-License-Identifier: BSD-3-Clause
// One step of a vtkShadowRenderStepsPass: another pass, with shadows on what it draws. Private to the module.
#ifndef vtkShadowedStepPass_h
#define vtkShadowedStepPass_h

#include "vtkRenderPass.h"

class vtkShadowMapPass;

class vtkShadowedStepPass : public vtkRenderPass
{
public:
  static vtkShadowedStepPass* New();
  vtkTypeMacro(vtkShadowedStepPass, vtkRenderPass);

  /// Sets what to draw in one frame: neither pass is kept alive. `bake` is for the first step with
  /// those shadows.
  void Set(vtkShadowMapPass* shadows, vtkRenderPass* delegate, bool bake);
  void Render(const vtkRenderState* s) override;

protected:
  vtkShadowedStepPass();
  ~vtkShadowedStepPass() override;

private:
  vtkShadowedStepPass(const vtkShadowedStepPass&) = delete;
  void operator=(const vtkShadowedStepPass&) = delete;

  vtkShadowMapPass* Shadows = nullptr;
  vtkRenderPass* Delegate = nullptr;
  bool Bake = false;
};

#endif
