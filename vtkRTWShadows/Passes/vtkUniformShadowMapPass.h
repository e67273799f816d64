// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkUniformShadowMapPass
 * @brief   the conventional shadow map: one layer a light, texels spread evenly
 *
 * With FocusOnView it is fitted to what the camera sees. It differs from the other techniques in nothing but the warp and so is
 * the baseline to measure them by.
 *
 * @sa vtkAdaptiveShadowMapPass vtkRTWShadowMapPass
 */
#ifndef vtkUniformShadowMapPass_h
#define vtkUniformShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class VTKRTWSHADOWS_EXPORT vtkUniformShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkUniformShadowMapPass* New();
  vtkTypeMacro(vtkUniformShadowMapPass, vtkAdaptiveShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkUniformShadowMapPass();
  ~vtkUniformShadowMapPass() override;

private:
  vtkUniformShadowMapPass(const vtkUniformShadowMapPass&) = delete;
  void operator=(const vtkUniformShadowMapPass&) = delete;
};

#endif
