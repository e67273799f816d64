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
  /// For what has been set up of that many clusters. There is room for so many covers; `prepare`
  /// gives a program what all need.
  void Find(int clusters, std::size_t mostCovers, const LayerTable& table,
    const std::function<void(const Program&)>& prepare);
  /// Those of the covers that are points; the others are in the first cluster's draw.
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
