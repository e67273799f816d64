// SPDX-License-Identifier: BSD-3-Clause
// The shadow mask: the visibility of each light at each pixel of the view, a byte in a layer of its own.
#ifndef rtwMaskStage_h
#define rtwMaskStage_h

#include "rtwDrawing.h"
#include "rtwFramebuffer.h"
#include "rtwProgram.h"
#include "rtwReceiverShader.h"
#include "rtwTexture.h"
#include "rtwWarpTable.h"

#include <string>

namespace rtw
{
class DenseLayers;
class ViewSampler;

class MaskStage
{
public:
  /// Compiles for that shape, unless that is done; false, with the reason in GetLog(), where the driver can't.
  bool Build(const ReceiverShape& shape, TableAccess access);
  const std::string& GetLog() const { return this->Drawing.GetLog(); }
  /// One layer a light.
  void Render(const ReceiverLights& lights, int otherLayers, const ViewSampler& samples,
    const DenseLayers& layers, const WarpTable& table);
  const Texture& GetMask() const { return this->Mask; }
  void Release();
  void Abandon();

private:
  ReceiverShape Shape;
  TableAccess Access = TableAccess::Texels;
  Program Drawing;
  Texture Mask;
  Framebuffer Target;
  ScreenTriangle Triangle;
};
}

#endif
