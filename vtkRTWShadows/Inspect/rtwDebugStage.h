// SPDX-License-Identifier: BSD-3-Clause
// What a light's map looks like from the view: debug views, and the aliasing error as numbers.
#ifndef rtwDebugStage_h
#define rtwDebugStage_h

#include "GL/rtwDrawing.h"
#include "GL/rtwFramebuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Lookup/rtwMapOfLight.h"
#include "Warp/rtwWarpStage.h"

#include <string>

namespace rtw
{
class Texture;

/// Debug views, numbered as vtkInspectableShadowMapPass::DebugViews.
enum class DebugView
{
  None,
  Shadow,
  AliasingError,
  Importance,
  WarpGrid,
  Layers,
  ListLengths
};

class DebugStage
{
public:
  /// Compiles for that warp, unless that is done; false, with the reason in GetLog(), where the
  /// driver can't.
  bool Build(const WarpShape& warp);
  std::string GetLog() const { return this->Painting.GetLog() + this->Measuring.GetLog(); }
  /// Paints a debug view over what is drawn of the view samples in the target and viewport that are
  /// bound. Only SHADOW looks at the mask. `rounding` is a distance that errors of depth don't
  /// exceed.
  void Paint(DebugView view, const MapOfLight& map, const Texture& mask, double rounding);
  /// Draws the aliasing error along s and t into a texture of two floats; false where that can't be
  /// drawn into.
  bool Measure(const MapOfLight& map, Texture& error);
  void Dispose(Disposal dispose);

private:
  const char* Warp = nullptr; ///< name of the warp that the programs are compiled for
  Program Painting, Measuring;
  Framebuffer Target;
  ScreenTriangle Triangle;
};
}

#endif
