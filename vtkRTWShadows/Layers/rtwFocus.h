// SPDX-License-Identifier: BSD-3-Clause
// Fits each layer to what the camera sees in the light: the desired view, by reduction on the GPU.
#ifndef rtwFocus_h
#define rtwFocus_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwSampleBounds.h"
#include "Light/rtwLightFrame.h"

#include <string>
#include <vector>

namespace rtw
{
class LayerTable;
struct View;

/// How far beyond what the camera sees a filter looks.
struct FilterReach
{
  double World = 0; ///< world units at the receiver, across the light
  double Share = 0; ///< a share of the map's side
};

class FocusStage
{
public:
  bool Build();
  std::string GetLog() const;
  /// Bounds what the camera sees in each light, for Reduce() and for whoever splits it by depth
  /// into so many layers.
  void Bound(const std::vector<LightFrame>& lights, const BoundedSamples& input, int parts);
  /// The same as SampleBounds::GetRange().
  const Buffer& GetRange() const { return this->Samples.GetRange(); }
  /// Writes the focus of each layer, of which `frames` has one each. `also` are rectangles that a
  /// light's only layer must hold too: receivers that aren't sampled. Of several layers each holds
  /// what lies in its depths of their boxes, given by eight corners each.
  void Reduce(const std::vector<LightFrame>& frames, const std::vector<Rectangle>& also,
    const std::vector<glm::dvec3>& boxes, const BoundedSamples& input, const FilterReach& filter);
  /// Where each layer has samples, by the last Reduce().
  const LayerBlocks& GetBlocks() const { return this->Blocks; }
  /// Forgets where layers have samples, since the samples are others by now.
  void ForgetBlocks() { this->Blocks.Forget(); }
  std::size_t GetMemory() const { return this->Samples.GetMemory() + this->Blocks.GetMemory(); }
  void Dispose(Disposal dispose);

private:
  void AddBoxes(const std::vector<LightFrame>& frames, const std::vector<glm::dvec3>& corners,
    const View& view, const FilterReach& filter, const LayerTable& table);

  SampleBounds Samples;
  LayerBlocks Blocks;
  Program BoxAdding, Writing;
  Buffer Bounds, Boxes;
};
}

#endif
