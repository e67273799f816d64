// SPDX-License-Identifier: BSD-3-Clause
// Finds the tiles of the map that cover the bent triangles of a light pass's clusters.
#ifndef rtwTileCovers_h
#define rtwTileCovers_h

#include "GL/rtwBuffer.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "Layers/rtwLayerTable.h"
#include "Warp/rtwWarpStage.h"

#include <cstddef>
#include <functional>
#include <string>

namespace rtw
{
class TileCovers
{
public:
  /// Texture units of the bent triangles and of their covers, which are to be bound.
  static constexpr int BentUnit = 9,
                       CoversUnit = 10; // as in rtwBentTable.glsl and rtwPointCasterVS.glsl

  /// Compiles for that warp, with the definitions that go before all shaders of the light pass;
  /// false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp, TableAccess access, const std::string& definitions);
  std::string GetLog() const;
  /// Finds the tiles of the triangles that have been set up of so many clusters. There is room for
  /// `mostCovers`; `prepare` gives a program what all programs need.
  void Find(int clusters, std::size_t mostCovers, const LayerTable& table,
    const std::function<void(const Program&)>& prepare);
  /// Draws those covers that are points; the others are in the first cluster's draw.
  void DrawPoints(const std::function<void(const Program&)>& prepare);
  std::size_t GetMemory() const { return this->Tiles.GetSize(); }
  void Dispose(Disposal dispose);

private:
  Program Starting, Planning, Dividing, Taking, Drawing;
  Buffer Tiles;
  PulledVertices Points;
};
}

#endif
