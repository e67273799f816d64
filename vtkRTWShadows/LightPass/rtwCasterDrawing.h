// SPDX-License-Identifier: BSD-3-Clause
// The light pass over the meshes of the geometry store: casters culled for each layer, then drawn into it, depth and gradient only.
#ifndef rtwCasterDrawing_h
#define rtwCasterDrawing_h

#include "rtwBuffer.h"
#include "rtwDrawing.h"
#include "rtwLightFrame.h"
#include "rtwProgram.h"
#include "rtwWarpStage.h"

#include <string>

namespace rtw
{
class GeometryStore;
class WarpTable;

struct CasterOptions
{
  bool Cull = true;  ///< leave out what cannot shadow anything in focus
  bool Exact = true; ///< draw triangles that the warp bends by their own edges
};

struct CasterCounts
{
  unsigned int Drawn = 0;  ///< clusters of triangles
  unsigned int Culled = 0;
};

class CasterDrawing
{
public:
  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp);
  std::string GetLog() const;
  /// Forgets what it counted of a layer.
  void StartLayer(int layer);
  /// Decides what of the store a layer needs.
  void Cull(const GeometryStore& store, const WarpTable& table, const LightFrame& frame, int layer,
    const CasterOptions& options);
  /// Draws it into the target that is bound.
  void Draw(const GeometryStore& store, const WarpTable& table, const LightFrame& frame, int layer);
  /// Of a layer in the last frame. Waits for the GPU.
  CasterCounts ReadCounts(int layer) const;
  void Release();
  void Abandon();

private:
  void Focus(const GeometryStore& store, const WarpTable& table, const LightFrame& frame, int layer);

  std::string Warp;
  Program Focusing, Culling, Plain, Bent;
  Buffer LightMatrices, Matrices, BentCommands, PlainCommands, Counts;
  MeshArray Array;
};
}

#endif
