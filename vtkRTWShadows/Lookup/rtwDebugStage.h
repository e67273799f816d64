// SPDX-License-Identifier: BSD-3-Clause
// What a light's map looks like from the view: debug views, and the aliasing error as numbers.
#ifndef rtwDebugStage_h
#define rtwDebugStage_h

#include "rtwDrawing.h"
#include "rtwFramebuffer.h"
#include "rtwProgram.h"
#include "rtwWarpStage.h"

#include <string>

namespace rtw
{
class Texture;
class ViewSampler;
class WarpTable;

/// As vtkInspectableShadowMapPass::DebugViews.
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

/// The map that is looked at, and from where.
struct DebuggedMap
{
  const LightFrame& Frame; ///< of its first layer
  int OtherLayers;         ///< how far behind a layer that of its other casters lies; 0 for none
  const ViewSampler& Samples;
  const WarpTable& Table;

  /// Uses a program of ours that looks at it.
  void Use(const Program& program) const;
};

class DebugStage
{
public:
  /// Compiles for that warp, unless that is done; false, with the reason in GetLog(), where the
  /// driver can't.
  bool Build(const WarpShape& warp);
  std::string GetLog() const { return this->Painting.GetLog() + this->Measuring.GetLog(); }
  /// Over what is drawn of the view samples in the target and viewport that are bound. Only SHADOW
  /// looks at the mask. `rounding` is a distance that errors of depth don't exceed.
  void Paint(DebugView view, const DebuggedMap& map, const Texture& mask, double rounding);
  /// The aliasing error along s and t into a texture of two floats; false where that can't be drawn
  /// into.
  bool Measure(const DebuggedMap& map, Texture& error);
  void Release();
  void Abandon();

private:
  const char* Warp = nullptr; ///< that is compiled
  Program Painting, Measuring;
  Framebuffer Target;
  ScreenTriangle Triangle;
};
}

#endif
