// SPDX-License-Identifier: BSD-3-Clause
// The shadow mask: the visibility of each light at each pixel of the view, a byte in a layer of its own.
#ifndef rtwMaskStage_h
#define rtwMaskStage_h

#include "GL/rtwBuffer.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwFramebuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexture.h"
#include "Layers/rtwLayerTable.h"
#include "Lookup/rtwReceiverShader.h"

#include <string>

namespace rtw
{
class DenseLayers;
class ViewSampler;

/// What a lookup looks at.
struct MaskLookup
{
  const ReceiverLights& Lights;
  /// How far behind a layer the one of casters that only VTK's mappers draw lies; 0 for none.
  int OtherLayers;
  const DenseLayers& Layers;
  const LayerTable& Table;
};

class MaskStage
{
public:
  /// Compiles for that shape, unless that is done; false, with the reason in GetLog(), where the
  /// driver can't. Several layers a light are chosen among by uniforms, or by the table.
  bool Build(const ReceiverShape& shape, TableAccess access, bool layersInUniforms);
  std::string GetLog() const { return this->Drawing.GetLog() + this->Gathering.GetLog(); }
  /// Draws the mask of each light into a layer of its own.
  void Render(const ReceiverLights& lights, int otherLayers, const ViewSampler& samples,
    const DenseLayers& layers, const LayerTable& table);
  /// For a MaskSource, which fills the mask by itself: makes room for so many lights, and makes a
  /// layer the target of drawing.
  void Allocate(const ViewSampler& samples, int lights);
  bool BindTarget(int light);
  /// The same for the samples of pixels that have several: a bit for each, from bit 0 on for those
  /// in shadow, from bit 8 on for those that face the light. Where none faces it the mask counts.
  void AllocateBits(const ViewSampler& samples, int lights);
  bool BindBits(int light);
  void ClearBits();
  const Texture& GetBits() const { return this->Bits; }
  /// Gives a program with a light's lookup in it what that needs; it begins at that layer.
  static void SetLookup(
    const Program& program, const MaskLookup& lookup, int light, int firstLayer);
  const Texture& GetMask() const { return this->Mask; }
  void Dispose(Disposal dispose);

private:
  void GatherLayers(const LayerTable& table, int layers);
  void BindGathered(int light) const;

  ReceiverShape Shape;
  bool LayersInUniforms = false;
  TableAccess Access = TableAccess::Texels;
  Program Drawing, Gathering;
  Buffer Gathered;
  Texture Mask, Bits;
  Framebuffer Target, BitsTarget;
  ScreenTriangle Triangle;
};
}

#endif
