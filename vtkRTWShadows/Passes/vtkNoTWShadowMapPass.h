// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNoTWShadowMapPass
 * @brief   non-orthogonal texture warping: one map a light, each row and each column of it warped
 * by a function of its own
 *
 * T. Milet, J. Navrátil, P. Zemčík, An Improved Non-Orthogonal Texture Warping for Better Shadow
 * Rendering, 2015.
 *
 * @sa vtkAdaptiveShadowMapPass vtkNonOrthogonalShadowMapWarp
 */
#ifndef vtkNoTWShadowMapPass_h
#define vtkNoTWShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class vtkNonOrthogonalShadowMapWarp;

class VTKRTWSHADOWS_EXPORT vtkNoTWShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkNoTWShadowMapPass* New();
  vtkTypeMacro(vtkNoTWShadowMapPass, vtkAdaptiveShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The warp that the pass begins with, which has the settings of the technique. It stays the same
   * object when another warp is set.
   */
  vtkNonOrthogonalShadowMapWarp* GetNonOrthogonalWarp();

protected:
  vtkNoTWShadowMapPass();
  ~vtkNoTWShadowMapPass() override;

private:
  vtkNoTWShadowMapPass(const vtkNoTWShadowMapPass&) = delete;
  void operator=(const vtkNoTWShadowMapPass&) = delete;

  vtkNew<vtkNonOrthogonalShadowMapWarp> NonOrthogonal;
};

#endif
