// SPDX-License-Identifier: BSD-3-Clause
// The bounds of view samples, by reduction on the GPU: first of small blocks of them, of which each
// layer then takes what lies in its depths, so that samples are looked at once however many layers
// there are.
#ifndef rtwSampleBounds_h
#define rtwSampleBounds_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Light/rtwLightFrame.h"

#include <string>

namespace rtw
{
class LayerBlocks;
class ViewSampler;
class LayerTable;

/// The view samples whose bounds are found.
struct BoundedSamples
{
  const ViewSampler& Samples;
  int Stride;
  float FilterWidth; ///< how far in the world a filter looks around a receiver
  const LayerTable& Table;
};

class SampleBounds
{
public:
  /// `placing` is code that defines rtwPlaced(): where a box on the light plane is bounded.
  bool Build(const std::string& placing);
  std::string GetLog() const;
  /// Makes room for blocks of so many lights, and for so many layers of one.
  void Start(const BoundedSamples& input, int lights, int parts);
  /// Bounds the blocks of a light, or for a layer of its own if what is placed depends on that.
  /// Nothing outside `whole` counts.
  void Bound(
    const BoundedSamples& input, const LightFrame& frame, int light, const Rectangle& whole);
  /// Adds the light's blocks to the bounds of `parts` of its layers from that frame's layer on:
  /// eight numbers a layer, in the order of rtwFocusBounds.glsl. Fills `lists`, where there are
  /// any.
  void Unite(const BoundedSamples& input, const LightFrame& frame, int light, int parts,
    const Rectangle& whole, const Buffer& bounds, const LayerBlocks* lists);
  /// The nearest and the farthest distance along the view direction, as bits of floats, of the
  /// samples that each bounded light reaches.
  const Buffer& GetRange() const { return this->Range; }
  std::size_t GetMemory() const { return this->Blocks.GetSize() + this->Visits.GetSize(); }
  void Dispose(Disposal dispose);

private:
  void Bind(const Program& program, const BoundedSamples& input, const LightFrame& frame,
    const Rectangle& whole) const;

  Program Bounding, Uniting, Visiting;
  Buffer Blocks, Range, Visits;
};
}

#endif
