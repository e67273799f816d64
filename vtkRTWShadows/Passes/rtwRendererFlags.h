// SPDX-License-Identifier: BSD-3-Clause
// The passes behind a vtkRenderer's flags (UseSSAO, UseHiddenLineRemoval, UseDepthPeeling, UseOIT, UseFXAA), which VTK
// heeds only where the renderer has no pass. Each is set up as vtkOpenGLRenderer does it, in each frame.
#ifndef rtwRendererFlags_h
#define rtwRendererFlags_h

#include "vtkNew.h"

#include <memory>

class vtkDepthPeelingPass;
class vtkOrderIndependentTranslucentPass;
class vtkRenderPass;
class vtkRenderState;
class vtkSSAOPass;
class vtkWindow;

namespace rtw
{
class FXAAStep;
class HiddenLinesStep;

class RendererFlags
{
public:
  RendererFlags();
  ~RendererFlags();
  RendererFlags(const RendererFlags&) = delete;
  RendererFlags& operator=(const RendererFlags&) = delete;

  /// Takes note of a frame's flags and props; to be called first.
  void Begin(const vtkRenderState* s);

  /// The pass that draws opaque props: the plain one that is given, unless lines are to be hidden.
  vtkRenderPass* DrawOpaque(const vtkRenderState* s, vtkRenderPass* opaque);
  /// The pass around the opaque step, or the step itself where there is none. Hidden lines have
  /// none, as in VTK.
  vtkRenderPass* AroundOpaque(const vtkRenderState* s, vtkRenderPass* step);
  /// The pass that draws translucent props, or that plain one that is given. Null where nothing is translucent.
  /// Inside another pass only peeling is heeded: blending in any order draws aside, where that pass's code is wrong.
  vtkRenderPass* DrawTranslucent(
    const vtkRenderState* s, vtkRenderPass* translucent, vtkRenderPass* volumetric);
  /// Whether that pass draws the volumes too.
  bool PeelsVolumes() const { return this->PeeledVolumes; }
  /// The pass between translucent props and volumes; null for none.
  vtkRenderPass* AfterTranslucent(const vtkRenderState* s);

  void ReleaseGraphicsResources(vtkWindow* w);

private:
  vtkRenderPass* Blend(const vtkRenderState* s);
  vtkRenderPass* Peel(const vtkRenderState* s, vtkRenderPass* volumetric);

  bool HidesLines = false;
  bool HasTranslucent = false;
  bool Inside = false; ///< another pass, which has code of its own in the props' shaders or draws aside
  bool PeeledVolumes = false;
  vtkNew<HiddenLinesStep> HiddenLines;
  vtkNew<vtkSSAOPass> Occlusion;
  // Those that put code into mappers' shaders are their window's: else viewports that share
  // translucent actors would have these built anew again and again.
  std::shared_ptr<vtkOrderIndependentTranslucentPass> Blending;
  std::shared_ptr<vtkDepthPeelingPass> Peeling; // one of two kinds
  vtkNew<FXAAStep> Smoothing;
};
}

#endif
