// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/Tiles/rtwTileCovers.h"

#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwWarpFocus.h"
#include "LightPass/Bent/rtwBentCasterFS.h"
#include "LightPass/Bent/rtwCasterGradient.h"
#include "LightPass/Bent/rtwCasterPlane.h"
#include "LightPass/Culling/rtwDeepest.h"
#include "LightPass/Culling/rtwDeepestIn.h"
#include "LightPass/rtwCasterRecords.h"
#include "LightPass/rtwCasterWork.h"
#include "LightPass/Tiles/rtwBentTable.h"
#include "LightPass/Tiles/rtwCoveredTiles.h"
#include "LightPass/Tiles/rtwDivideTiles.h"
#include "LightPass/Tiles/rtwFirstTiles.h"
#include "LightPass/Tiles/rtwPlanTiles.h"
#include "LightPass/Tiles/rtwPointCasterVS.h"
#include "LightPass/Tiles/rtwTakeTexels.h"

#include <algorithm>

namespace rtw
{
namespace
{
constexpr unsigned int TilesBinding = 4; // binding of Tiles in rtwCoveredTiles.glsl
constexpr int TakenList = 2;
constexpr float LargestPoint = 64; // texels a side; a larger cover is drawn as two triangles
constexpr std::size_t GroupsOffset = 12, PointDrawOffset = 32;
constexpr std::size_t HeaderBytes = 48, TileBytes = 8;
}

bool TileCovers::Build(const WarpShape& warp, TableAccess access, const std::string& definitions)
{
  const char* const stored = LayerTable::DefinitionOf(access);
  const auto build = [&](Program& program, const char* code) {
    return program.Build({ { GL_COMPUTE_SHADER,
      { "#define TILES_GROUP 64u\n", stored, rtwWarpFocus, warp.Function, warp.Bend,
        definitions.c_str(), rtwDeepest, rtwDeepestIn, rtwCasterWork, rtwCasterRecords,
        rtwBentTable, rtwCoveredTiles, code } } });
  };
  return build(this->Starting, rtwFirstTiles) && build(this->Planning, rtwPlanTiles) &&
    build(this->Dividing, rtwDivideTiles) && build(this->Taking, rtwTakeTexels) &&
    this->Drawing.Build(
      { { GL_VERTEX_SHADER, { definitions.c_str(), rtwBentTable, rtwPointCasterVS } },
        { GL_FRAGMENT_SHADER,
          { stored, rtwWarpFocus, warp.Function, rtwCasterGradient, rtwCasterPlane,
            rtwBentCasterFS } } });
}

std::string TileCovers::GetLog() const
{
  return this->Starting.GetLog() + this->Planning.GetLog() + this->Dividing.GetLog() +
    this->Taking.GetLog() + this->Drawing.GetLog();
}

void TileCovers::Find(int clusters, std::size_t mostCovers, const LayerTable& table,
  const std::function<void(const Program&)>& prepare)
{
  this->Tiles.Reserve(HeaderBytes + 3 * TileBytes * mostCovers);
  const unsigned int none[12] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0 };
  this->Tiles.Write(0, none, sizeof(none));
  this->Tiles.BindStorage(TilesBinding);
  prepare(this->Starting);
  Dispatch(clusters);
  prepare(this->Planning);
  prepare(this->Dividing);
  prepare(this->Taking);
  const float largest = std::min(LargestPoint, LargestPointSize());
  for (const Program* program : { &this->Dividing, &this->Taking })
  {
    program->Use();
    program->Set("rtwLargestPoint", static_cast<int>(largest));
  }
  const auto run = [this](const Program& program, int list) {
    this->Planning.Use();
    this->Planning.Set("rtwTileList", list);
    Dispatch(1);
    program.Use();
    program.Set("rtwTileList", list);
    DispatchIndirect(this->Tiles, GroupsOffset);
  };
  for (int level = 0; level < table.GetTileLevels(); ++level)
  {
    run(this->Dividing, level % 2);
  }
  run(this->Taking, TakenList);
}

void TileCovers::DrawPoints(const std::function<void(const Program&)>& prepare)
{
  prepare(this->Drawing);
  this->Points.DrawIndirect(Primitive::Points, this->Tiles, PointDrawOffset, 1, 16);
}

void TileCovers::Dispose(Disposal dispose)
{
  dispose(this->Starting, this->Planning, this->Dividing, this->Taking, this->Drawing, this->Tiles,
    this->Points);
}
}
