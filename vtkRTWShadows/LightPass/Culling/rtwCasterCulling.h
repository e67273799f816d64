// SPDX-License-Identifier: BSD-3-Clause
// Which clusters of the geometry store can cast a shadow into a layer that is seen: a list of them,
// so that the rest of the light pass costs what is drawn, not what the scene holds.
#ifndef rtwCasterCulling_h
#define rtwCasterCulling_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Layers/rtwLayerTable.h"
#include "LightPass/rtwCasterLayer.h"
#include "Warp/rtwWarpStage.h"

#include <array>
#include <cstddef>
#include <string>

namespace rtw
{
class CasterCulling
{
public:
  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp, TableAccess access);
  std::string GetLog() const;
  /// Forgets what it counted of a layer.
  void StartLayer(int layer);
  /// Lists a layer's clusters.
  void Cull(const CasterLayer& layer);
  /// The matrix of each instance from the mesh to the layer's focus.
  const Buffer& GetMatrices() const { return this->Matrices; }
  /// The list that rtwListClusters.glsl writes.
  const Buffer& GetList() const { return this->List; }
  /// The clusters of a layer that were drawn and culled in the last frame. Waits for the GPU.
  CasterCounts ReadCounts(int layer) const;
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  std::array<Program*, 3> Programs() { return { &this->Focusing, &this->Culling, &this->Listing }; }
  std::array<Buffer*, 5> Buffers();
  void Focus(const CasterLayer& layer);

  Program Focusing, Culling, Listing;
  Buffer LightMatrices, Matrices, Bent, List, Counts;
};
}

#endif
