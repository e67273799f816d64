// SPDX-License-Identifier: BSD-3-Clause
// The storage axis: what fills the shadow mask in place of a lookup in maps. A pipeline that has
// none draws maps and looks them up.
#ifndef rtwMaskSource_h
#define rtwMaskSource_h

#include "Frame/rtwView.h"
#include "GL/rtwResources.h"
#include "Layers/rtwLayerTable.h"
#include "LightPass/rtwCasterLayer.h"
#include "Lookup/rtwReceiverShader.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rtw
{
class DenseLayers;
class GeometryStore;
class MaskStage;
class StageTimers;
class ViewSampler;

/// The data of a frame that a mask is made from.
struct MaskJob
{
  const std::vector<LightFrame>& Frames;
  const View& Viewed;
  const ViewSampler& Samples;
  const GeometryStore& Store;
  const LayerTable& Table;
  /// maps, of which only those of casters that only VTK's mappers draw are drawn
  const DenseLayers& Layers;
  const ReceiverLights& Lights;
  const ReceiverShape& Shape;
  TableAccess Access; ///< how compute shaders read the table
  int OtherLayers;
  double SceneSize;
  bool Cull;
};

class MaskSource : public ResourceOwner
{
public:
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  virtual bool Build(const MaskJob& job) = 0;
  virtual std::string GetLog() const = 0;
  /// Draws each light's mask. False where the driver can't draw into it.
  virtual bool Render(const MaskJob& job, MaskStage& masking, StageTimers& timers) = 0;
  /// Has the GPU draw what is to take the mask's place, if it turned out that Render() could not do
  /// all of it.
  virtual void WhereIncomplete(const std::function<void()>& draw) = 0;
  /// Whether it is known that Render() was incomplete since this was asked last, so that the frame
  /// is worth drawing again. Never waits.
  virtual bool WasIncomplete() = 0;
  /// Paints how many view samples each texel holds over what is drawn of the samples in the target
  /// and viewport that are bound. False where texels hold no samples, or the driver can't.
  virtual bool PaintLists(const MaskJob& job, int light, double rounding) = 0;
  /// A number that changes with all settings that the mask depends on.
  virtual std::uint64_t GetSignature() const = 0;
  /// The clusters of a light that were drawn and culled in the last frame. Waits for the GPU.
  virtual CasterCounts ReadCounts(int light) const = 0;
  virtual std::size_t GetMemory() const = 0;
};
}

#endif
