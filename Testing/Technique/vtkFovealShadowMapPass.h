// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFovealShadowMapPass
 * @brief   the preset that names the foveal warp: one layer a light, texels densest in its middle
 */
#ifndef vtkFovealShadowMapPass_h
#define vtkFovealShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class vtkFovealShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkFovealShadowMapPass* New();
  vtkTypeMacro(vtkFovealShadowMapPass, vtkAdaptiveShadowMapPass);

protected:
  vtkFovealShadowMapPass();
  ~vtkFovealShadowMapPass() override;

private:
  vtkFovealShadowMapPass(const vtkFovealShadowMapPass&) = delete;
  void operator=(const vtkFovealShadowMapPass&) = delete;
};

#endif
