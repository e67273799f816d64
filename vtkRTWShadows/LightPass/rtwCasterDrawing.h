// SPDX-License-Identifier: BSD-3-Clause
// The light pass over the meshes of the geometry store: for each layer clusters are culled, then
// the triangles of those that are left are set up, and drawn, depth and gradient only.
#ifndef rtwCasterDrawing_h
#define rtwCasterDrawing_h

#include "rtwBuffer.h"
#include "rtwDrawing.h"
#include "rtwLightFrame.h"
#include "rtwProgram.h"
#include "rtwTileCovers.h"
#include "rtwWarpStage.h"
#include "rtwWarpTable.h"

#include <array>
#include <cstddef>
#include <string>

namespace rtw
{
class DeepestSamples;
class GeometryStore;

/// What becomes of triangles that the warp bends; the numbers are the users'.
enum class Bending
{
  Linear = 0,      ///< nothing
  Tessellated = 1, ///< they are cut up
  Exact = 2,       ///< they are drawn by their own edges
  Automatic = 3    ///< the same, where it can be seen
};

struct CasterOptions
{
  bool Cull = true; ///< leave out what cannot shadow anything in focus
  Bending Bends = Bending::Automatic;
  double EdgeLength = 0.025; ///< of tessellated triangles at most, of the map's side
  /// Of bent edges, that far at most are they drawn straight; where that is as they are in the
  /// mesh, of some that are long.
  double StraightLength() const
  {
    return this->Bends == Bending::Linear   ? 0.25
      : this->Bends == Bending::Tessellated ? this->EdgeLength
                                            : 0;
  }
};

struct CasterCounts
{
  unsigned int Drawn = 0; ///< clusters of triangles
  unsigned int Culled = 0;
};

class CasterDrawing
{
public:
  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp, TableAccess access);
  std::string GetLog() const;
  /// Forgets what it counted of a layer.
  void StartLayer(int layer);
  /// Draws what a layer needs of the store into the target that is bound.
  void Draw(const GeometryStore& store, const WarpTable& table, const LightFrame& frame, int layer,
    const CasterOptions& options, const DeepestSamples* deepest = nullptr);
  /// Of a layer in the last frame. Waits for the GPU.
  CasterCounts ReadCounts(int layer) const;
  std::size_t GetMemory() const;
  void Release();
  void Abandon();

private:
  struct Layer
  {
    const GeometryStore& Store;
    const WarpTable& Table;
    const LightFrame& Frame;
    int Index;

    CasterOptions Options;
    const DeepestSamples* Deepest;
  };

  std::array<Program*, 8> Programs();
  std::array<Buffer*, 7> Buffers();
  Bending BendingOf(const Layer& layer) const;
  void Prepare(const Program& program, const Layer& layer) const;
  void Focus(const Layer& layer);
  void Cull(const Layer& layer, int first, int end);
  void SetUp(const Layer& layer, int clusters);
  void DrawTriangles(const Layer& layer, int clusters);
  void DrawThin(const Layer& layer);

  std::string Warp;
  bool InTiles = false; ///< whether bent triangles are covered by tiles of the map
  bool Projective = false; ///< it keeps edges straight
  TableAccess Access = TableAccess::Storage;
  Program Focusing, Culling, CullingTriangles, SettingUp, Straight, Bent, Patches, Thin;
  Buffer LightMatrices, Matrices, Work, StraightCasters, BentCasters, Covers, Counts;
  PulledVertices Pulled;
  TileCovers Tiles;
  MeshArray Array;
};
}

#endif
