// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveShadowMapBakerPass
 * @brief   brings the shadow maps of a vtkAdaptiveShadowMapPass up to date
 *
 * The baker stands before its pass in the classic chain. It is made by its pass and has no settings
 * but the Resolution that it shares with it. Maps are drawn from the meshes themselves, so that
 * OpaqueSequence and CompositeZPass are not used.
 */
#ifndef vtkAdaptiveShadowMapBakerPass_h
#define vtkAdaptiveShadowMapBakerPass_h

#include "vtkRTWShadowsModule.h" // for the export macro
#include "vtkShadowMapBakerPass.h"
#include "vtkWeakPointer.h" // for the pass

class vtkAdaptiveShadowMapPass;

class VTKRTWSHADOWS_EXPORT vtkAdaptiveShadowMapBakerPass : public vtkShadowMapBakerPass
{
public:
  static vtkAdaptiveShadowMapBakerPass* New();
  vtkTypeMacro(vtkAdaptiveShadowMapBakerPass, vtkShadowMapBakerPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Texels a side of each layer. 0 is refused with an error. Default: 1024.
   */
  void SetResolution(unsigned int resolution) override;

  /**
   * Draws those shadow maps anew that the frame needs and that something has changed for. Draws
   * nothing to the window.
   */
  void Render(const vtkRenderState* s) override;
  /**
   * Frees the OpenGL objects that were made for that window. The next frame makes new ones.
   */
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkAdaptiveShadowMapBakerPass();
  ~vtkAdaptiveShadowMapBakerPass() override;

private:
  vtkAdaptiveShadowMapBakerPass(const vtkAdaptiveShadowMapBakerPass&) = delete;
  void operator=(const vtkAdaptiveShadowMapBakerPass&) = delete;

  friend class vtkAdaptiveShadowMapPass;
  vtkWeakPointer<vtkAdaptiveShadowMapPass> ShadowMapPass;
  bool Warned = false;
};

#endif
