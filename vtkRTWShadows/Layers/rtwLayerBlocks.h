// SPDX-License-Identifier: BSD-3-Clause
// How analyses go through view samples (rtwVisitSamples.glsl): all of them, or those blocks in
// which a layer has any.
#ifndef rtwLayerBlocks_h
#define rtwLayerBlocks_h

#include "GL/rtwBuffer.h"
#include "GL/rtwResources.h"

namespace rtw
{
class Program;
class ViewSampler;

class LayerBlocks
{
public:
  /// The number of blocks, if there is a sample every so many pixels along both axes.
  static int Count(const ViewSampler& samples, int stride);
  /// Makes room for lists of so many layers of those samples, for rtwUniteBlocks.glsl to fill.
  void Start(int layers, const ViewSampler& samples, int stride);
  /// Forgets the lists: there are none until the next Start().
  void Forget() { this->Layers = 0; }
  /// Binds the lists for the shader that fills them, and tells it where they are.
  void BindForListing(const Program& program) const;
  /// Runs a program, which is in use, for the samples of a layer or, below 0, for all.
  void Dispatch(const Program& program, const ViewSampler& samples, int stride, int layer) const;
  std::size_t GetMemory() const { return this->Lists.GetSize(); }
  void Dispose(Disposal dispose);

private:
  bool Holds(const ViewSampler& samples, int stride, int layer) const;

  Buffer Lists;
  int Layers = 0;
  int Blocks = 0; ///< blocks that a list has room for
  int Stride = 0;
  int Width = 0, Height = 0;
};
}

#endif
