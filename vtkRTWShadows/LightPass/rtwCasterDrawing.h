// SPDX-License-Identifier: BSD-3-Clause
// The light pass over the meshes of the geometry store: for each layer clusters are culled, then
// the triangles of those that are left are set up, and drawn, depth and gradient only.
#ifndef rtwCasterDrawing_h
#define rtwCasterDrawing_h

#include "GL/rtwBuffer.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexelBuffer.h"
#include "Layers/rtwLayerTable.h"
#include "Light/rtwLightFrame.h"
#include "LightPass/Culling/rtwCasterCulling.h"
#include "LightPass/rtwCasterLayer.h"
#include "LightPass/Tiles/rtwTileCovers.h"
#include "Warp/rtwWarpStage.h"

#include <array>
#include <cstddef>
#include <string>

namespace rtw
{
class CasterDrawing
{
public:
  /// Texels of a buffer texture that a warp with a grid needs at least.
  static constexpr int TexelsOfTiles = 786432;
  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp, TableAccess access);
  std::string GetLog() const;
  /// Forgets what it counted of a layer.
  void StartLayer(int layer) { this->Clusters.StartLayer(layer); }
  /// Draws what a layer needs of the store into the target that is bound.
  void Draw(const GeometryStore& store, const LayerTable& table, const LightFrame& frame, int layer,
    const CasterOptions& options, const DeepestSamples* deepest = nullptr);
  /// The clusters of a layer that were drawn and culled in the last frame. Waits for the GPU.
  CasterCounts ReadCounts(int layer) const { return this->Clusters.ReadCounts(layer); }
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  std::array<Program*, 7> Programs();
  std::array<Buffer*, 3> Buffers();
  Bending BendingOf(const CasterOptions& options) const;
  void Start(const CasterLayer& layer, int first, int most);
  void SetUp(const CasterLayer& layer, int clusters);
  void DrawTriangles(const CasterLayer& layer, int clusters);

  std::string Warp;
  bool InTiles = false; ///< whether bent triangles are covered by tiles of the map
  bool Projective = false; ///< whether the warp keeps edges straight
  TableAccess Access = TableAccess::Storage;
  CasterCulling Clusters;
  Program Starting, CullingTriangles, SettingUp, Straight, Plane, Bent, Patches;
  Buffer Work, WorkGroups, StraightCasters;
  TexelBuffer BentCasters, Covers;
  PulledVertices Pulled;
  TileCovers Tiles;
};
}

#endif
