// SPDX-License-Identifier: BSD-3-Clause
// The contract of a partition: how many layers a light has, and what of the view each is for.
//
// Implemented by WholeViewStage (below) and DepthSplitStage.
#ifndef rtwPartitionStage_h
#define rtwPartitionStage_h

#include "GL/rtwResources.h"
#include "Layers/rtwFocus.h"
#include "Light/rtwLightFrame.h"

#include <optional>
#include <string>
#include <vector>

namespace rtw
{
class Buffer;
class LayerBlocks;
class ViewSampler;
class LayerTable;
struct View;

struct PartitionInput
{
  const std::vector<LightFrame>& Frames; ///< one frame for each light
  const View& Viewed;
  const void* Viewer;         ///< who looks, only compared with others
  const ViewSampler& Samples; ///< the view samples, where they are needed
  const LayerBlocks& Blocks;
  const Buffer& Range; ///< SampleBounds::GetRange(), where it is needed
  int Stride = 1;
  int Parts = 1;      ///< layers a light, GetNumberOfLayers() or fewer
  int Faces = 1;      ///< layers of the same depths, one for each side of the view frustum; 1 or 4
  int Resolution = 1; ///< texels a side of a layer
  bool FocusOnView = true;
  FilterReach Reach;
};

class PartitionStage : public ResourceOwner
{
public:
  virtual int GetNumberOfLayers() const = 0; ///< layers of each light
  /// Sides of the view frustum that each range of depths is divided among: 4, or 1 for none. Layers
  /// of the same depths stand together.
  virtual int GetNumberOfFaces() const { return 1; }
  /// Whether a layer gives way to the next little by little.
  virtual bool Blends() const { return false; }
  virtual bool NeedsViewSamples() const = 0;
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  virtual bool Build() = 0;
  virtual std::string GetLog() const = 0;
  /// Whether depths don't go by view samples, and layers move by whole texels, which are square.
  virtual bool IsFixed(const PartitionInput&) const { return false; }
  /// Writes each layer's interval into the table; layers of a light stand together.
  virtual void Split(const PartitionInput& input, LayerTable& table) = 0;
  /// The rectangle that the layer of a frame has to cover, where that doesn't go by view samples.
  virtual std::optional<Rectangle> FocusOf(const LightFrame&, const PartitionInput&) const
  {
    return {};
  }
};

class WholeViewStage : public PartitionStage
{
public:
  int GetNumberOfLayers() const override { return 1; }
  bool NeedsViewSamples() const override { return false; }
  bool Build() override { return true; }
  std::string GetLog() const override { return {}; }
  void Split(const PartitionInput&, LayerTable&) override {}
  void Dispose(Disposal) override {}
};
}

#endif
