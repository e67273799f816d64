// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowMapWarp
 * @brief   how a shadow map's texels are spread over the light plane
 *
 * A warp is a monotone, invertible map from light-plane coordinates in [0,1]² to shadow-map coordinates. It is one of the
 * independent axes of a vtkAdaptiveShadowMapPass; the classes derived from that pass are presets that name a warp.
 * One object may serve several passes.
 *
 * @sa vtkIdentityShadowMapWarp vtkRectilinearShadowMapWarp vtkAdaptiveShadowMapPass
 */
#ifndef vtkShadowMapWarp_h
#define vtkShadowMapWarp_h

#include "vtkObject.h"
#include "vtkRTWShadowsModule.h" // for the export macro

#include <memory> // for the stage

namespace rtw
{
class WarpStage;
}

class VTKRTWSHADOWS_EXPORT vtkShadowMapWarp : public vtkObject
{
public:
  vtkTypeMacro(vtkShadowMapWarp, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /**
   * The GPU side of this warp, for one pass. It asks this object for its settings, which has to
   * stay as long as it is in use.
   */
  virtual std::unique_ptr<rtw::WarpStage> MakeStage() = 0;
#endif

protected:
  vtkShadowMapWarp();
  ~vtkShadowMapWarp() override;

private:
  vtkShadowMapWarp(const vtkShadowMapWarp&) = delete;
  void operator=(const vtkShadowMapWarp&) = delete;
};

#endif
