// SPDX-License-Identifier: BSD-3-Clause
// What each light sees of the focus, before there is a warp: the depth image of forward analysis
// (Rosen 2012, section 4.1).
#ifndef rtwLightImages_h
#define rtwLightImages_h

#include "GL/rtwResources.h"
#include "Layers/rtwDenseLayers.h"
#include "Layers/rtwLayerTable.h"
#include "LightPass/rtwCasterDrawing.h"

namespace rtw
{
class LightImages
{
public:
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  bool Build();
  std::string GetLog() const { return this->Casters.GetLog(); }
  /// Makes images of that size, one for each map layer: `lights` of them, each over the focus that
  /// the layer has in that table.
  void Start(int size, int lights, const LayerTable& focused);
  /// Draws the image of a layer, and leaves it the target of drawing. False where the driver can't
  /// draw into it.
  bool Draw(const GeometryStore& store, const LightFrame& frame, int light, bool cull);
  const DenseLayers& GetImages() const { return this->Images; }
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  DenseLayers Images;
  LayerTable Table;
  CasterDrawing Casters;
};
}

#endif
