// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIdentityShadowMapWarp
 * @brief   no warp: texels lie evenly on the light plane, as on a conventional shadow map
 *
 * @sa vtkUniformShadowMapPass
 */
#ifndef vtkIdentityShadowMapWarp_h
#define vtkIdentityShadowMapWarp_h

#include "vtkShadowMapWarp.h"

class VTKRTWSHADOWS_EXPORT vtkIdentityShadowMapWarp : public vtkShadowMapWarp
{
public:
  static vtkIdentityShadowMapWarp* New();
  vtkTypeMacro(vtkIdentityShadowMapWarp, vtkShadowMapWarp);

#ifndef __VTK_WRAP__
  std::unique_ptr<rtw::WarpStage> MakeStage() override;
#endif

protected:
  vtkIdentityShadowMapWarp();
  ~vtkIdentityShadowMapWarp() override;

private:
  vtkIdentityShadowMapWarp(const vtkIdentityShadowMapWarp&) = delete;
  void operator=(const vtkIdentityShadowMapWarp&) = delete;
};

#endif
