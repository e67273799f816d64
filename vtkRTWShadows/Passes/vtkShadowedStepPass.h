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

  /// For one frame: neither is kept alive. `bake` for the first step that has them.
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
