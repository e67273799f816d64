// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFovealShadowMapWarp
 * @brief   texels lie densest in the middle of the focus, whatever is seen there
 *
 * It is what a warp from outside the module takes: this class, its stage, and three GLSL files.
 */
#ifndef vtkFovealShadowMapWarp_h
#define vtkFovealShadowMapWarp_h

#include "vtkShadowMapWarp.h"

class vtkFovealShadowMapWarp : public vtkShadowMapWarp
{
public:
  static vtkFovealShadowMapWarp* New();
  vtkTypeMacro(vtkFovealShadowMapWarp, vtkShadowMapWarp);

  std::unique_ptr<rtw::WarpStage> MakeStage() override;

protected:
  vtkFovealShadowMapWarp();
  ~vtkFovealShadowMapWarp() override;

private:
  vtkFovealShadowMapWarp(const vtkFovealShadowMapWarp&) = delete;
  void operator=(const vtkFovealShadowMapWarp&) = delete;
};

#endif
