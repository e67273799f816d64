// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/rtwCasterDrawing.h"

#include "Frame/rtwClusterDraw.h"
#include "Frame/rtwGeometryStore.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwWarpFocus.h"
#include "LightPass/Bent/rtwBentCasterFS.h"
#include "LightPass/Bent/rtwBentCasterVS.h"
#include "LightPass/Bent/rtwCasterCovers.h"
#include "LightPass/Bent/rtwCasterGradient.h"
#include "LightPass/Bent/rtwCasterPlane.h"
#include "LightPass/Bent/rtwCasterTriangle.h"
#include "LightPass/Bent/rtwCoverCasters.h"
#include "LightPass/Bent/rtwCoveredCaster.h"
#include "LightPass/Bent/rtwCoverInFront.h"
#include "LightPass/Bent/rtwPatchClasses.h"
#include "LightPass/Bent/rtwSetUpCasters.h"
#include "LightPass/Bent/rtwTessellateCasters.h"
#include "LightPass/Bent/rtwTessellatedCasterVS.h"
#include "LightPass/Culling/rtwCullTriangles.h"
#include "LightPass/Culling/rtwDeepest.h"
#include "LightPass/Culling/rtwDeepestIn.h"
#include "LightPass/Culling/rtwStartClusters.h"
#include "LightPass/rtwCasterRecords.h"
#include "LightPass/rtwCasterWork.h"
#include "LightPass/Straight/rtwPlaneCasterFS.h"
#include "LightPass/Straight/rtwPlaneCasterVS.h"
#include "LightPass/Straight/rtwStraightCasterFS.h"
#include "LightPass/Straight/rtwStraightCasterVS.h"
#include "LightPass/Tiles/rtwCoverByTiles.h"

#include <algorithm>

namespace rtw
{
namespace
{
constexpr std::size_t MostTriangles = MeshCluster::MaximumTriangles;
// Classes of patches: triangles of 1, 2, 4, 8 and 16 pieces along an edge at most.
constexpr std::size_t PatchClasses = 5;
// Bytes that the shaders keep of a cluster (rtwCasterWork.glsl), by the rules of std430.
constexpr std::size_t WorkBytes = 80 + 16 * PatchClasses + 4 * MostTriangles;
constexpr std::size_t WorkGroupsBytes = 12;
constexpr std::size_t StraightBytes = 56 * MostTriangles;
constexpr std::size_t BentBytes = 128 * MostTriangles;
constexpr std::size_t CoverBytes = 32;
// The clusters that are set up at a time, so that the memory which that takes is bounded.
constexpr int MostClusters = 128;
constexpr std::size_t MostCovers = 3072; // covers of a cluster
static_assert(CasterDrawing::TexelsOfTiles == CoverBytes / 16 * MostClusters * MostCovers, "room");
// Tiles have the room of all together, and some clusters' few large triangles need thousands.
constexpr int MostClustersInTiles = 64;
constexpr std::size_t FinePatches =
  (PatchClasses - 1) * MostTriangles;      // the patches of all classes but the last
constexpr std::size_t BentDrawOffset = 16; // bytes from the beginning of a cluster's CasterWork
constexpr std::size_t PlaneDrawOffset = 32;
constexpr std::size_t PatchDrawOffset = 48;

std::string Limits()
{
  return "#define SET_UP_GROUP 32\nconst uint MOST_TRIANGLES = " + std::to_string(MostTriangles) +
    "u;\nconst uint MOST_COVERS = " + std::to_string(MostCovers) +
    "u;\nconst uint MOST_CLUSTERS = " + std::to_string(MostClusters) +
    "u;\nconst uint PATCH_CLASSES = " + std::to_string(PatchClasses) +
    "u;\nconst int PATCH_SIDE = " + std::to_string(1 << (PatchClasses - 1)) + ";\n";
}

const char* CoverOf(WarpKind kind)
{
  return kind == WarpKind::Separable ? rtwCoverCasters
    : kind == WarpKind::Grid         ? rtwCoverByTiles
                                     : rtwCoverInFront;
}
}

std::array<Program*, 7> CasterDrawing::Programs()
{
  return { &this->Starting, &this->CullingTriangles, &this->SettingUp, &this->Straight,
    &this->Plane, &this->Bent, &this->Patches };
}

std::array<Buffer*, 3> CasterDrawing::Buffers()
{
  return { &this->Work, &this->WorkGroups, &this->StraightCasters };
}

bool CasterDrawing::Build(const WarpShape& warp, TableAccess access)
{
  if (this->Warp != warp.Name || this->Access != access)
  {
    const Disposal dispose = Disposal::Release();
    dispose(this->Programs(), this->Clusters, this->Tiles);
    this->Warp = warp.Name;
    this->Access = access;
  }
  this->InTiles = warp.Kind == WarpKind::Grid;
  this->Projective = warp.Kind == WarpKind::Projective;
  const std::string limits = Limits();
  const char* const stored = LayerTable::DefinitionOf(access);
  const char* const cover = CoverOf(warp.Kind);
  // Where edges are straight, a cover is the triangle.
  const char* const covered = this->Projective ? rtwPlaneCasterFS : rtwBentCasterFS;
  return this->Clusters.Build(warp, access) &&
    this->Starting.Build({ { GL_COMPUTE_SHADER,
      { rtwClusterDraw, limits.c_str(), rtwPatchClasses, rtwCasterWork, rtwStartClusters } } }) &&
    this->CullingTriangles.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, limits.c_str(), rtwCasterWork,
        rtwCasterTriangle, rtwDeepest, rtwDeepestIn, rtwCullTriangles } } }) &&
    this->SettingUp.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, limits.c_str(), rtwCasterWork,
        rtwCasterTriangle, rtwCasterRecords, rtwPatchClasses, rtwCasterCovers, cover,
        rtwTessellateCasters, rtwSetUpCasters } } }) &&
    this->Straight.Build({ { GL_VERTEX_SHADER, { rtwCasterRecords, rtwStraightCasterVS } },
      { GL_FRAGMENT_SHADER, { rtwCasterGradient, rtwStraightCasterFS } } }) &&
    this->Plane.Build(
      { { GL_VERTEX_SHADER, { limits.c_str(), rtwCasterRecords, rtwPlaneCasterVS } },
        { GL_FRAGMENT_SHADER,
          { stored, rtwWarpFocus, warp.Function, rtwCasterGradient, rtwCasterPlane,
            rtwPlaneCasterFS } } }) &&
    this->Bent.Build({ { GL_VERTEX_SHADER,
                         { rtwCasterRecords, rtwCoveredCaster, rtwBentCasterVS } },
      { GL_FRAGMENT_SHADER,
        { stored, rtwWarpFocus, warp.Function, rtwCasterGradient, rtwCasterPlane, covered } } }) &&
    this->Patches.Build({ { GL_VERTEX_SHADER,
                            { stored, rtwWarpFocus, warp.Function, limits.c_str(), rtwPatchClasses,
                              rtwCasterRecords, rtwTessellatedCasterVS } },
      { GL_FRAGMENT_SHADER,
        { stored, rtwWarpFocus, warp.Function, rtwCasterGradient, rtwCasterPlane,
          rtwPlaneCasterFS } } }) &&
    (!this->InTiles || this->Tiles.Build(warp, access, limits));
}

std::string CasterDrawing::GetLog() const
{
  return this->Clusters.GetLog() + this->Starting.GetLog() + this->CullingTriangles.GetLog() +
    this->SettingUp.GetLog() + this->Straight.GetLog() + this->Plane.GetLog() +
    this->Bent.GetLog() + this->Patches.GetLog() + this->Tiles.GetLog();
}

std::size_t CasterDrawing::GetMemory() const
{
  return this->Clusters.GetMemory() + this->Work.GetSize() + this->StraightCasters.GetSize() +
    this->BentCasters.GetMemory() + this->Covers.GetMemory() + this->Tiles.GetMemory();
}

// Exact is the same as Linear where the warp keeps edges straight. Under a grid whole
// neighbourhoods bend alike:
// what cannot be seen of one triangle can be seen of all.
Bending CasterDrawing::BendingOf(const CasterOptions& options) const
{
  const bool exact = this->Projective || (this->InTiles && options.Bends == Bending::Automatic);
  return exact ? Bending::Exact : options.Bends;
}

void CasterDrawing::Start(const CasterLayer& layer, int first, int most)
{
  this->Work.Reserve(WorkBytes * most);
  this->WorkGroups.Reserve(WorkGroupsBytes);
  this->Starting.Use();
  layer.Store.GetClusters().BindStorage(0);
  layer.Store.GetDraws().BindStorage(1);
  this->Work.BindStorage(3);
  this->Clusters.GetList().BindStorage(4);
  this->WorkGroups.BindStorage(5);
  this->Starting.Set("rtwFirst", first);
  this->Starting.Set("rtwMost", most);
  Dispatch(Groups(most, 64));
}

void CasterDrawing::SetUp(const CasterLayer& layer, int clusters)
{
  this->StraightCasters.Reserve(StraightBytes * clusters);
  this->BentCasters.Allocate(4, BentBytes / 16 * clusters);
  // Patches lie behind the covers.
  const bool tessellates = layer.Bends == Bending::Tessellated;
  const std::size_t most = MostClusters * MostCovers;
  this->Covers.Allocate(4,
    CoverBytes / 16 *
      (tessellates        ? 2 * most + MostClusters * FinePatches
          : this->InTiles ? most
                          : MostCovers * clusters));
  layer.Store.GetPoints().BindStorage(0);
  layer.Store.GetIndices().BindStorage(1);
  this->Clusters.GetMatrices().BindStorage(2);
  this->Work.BindStorage(3);
  this->StraightCasters.BindStorage(4);
  this->BentCasters.BindStorage(5);
  this->Covers.BindStorage(6);
  for (const Program* program : { &this->CullingTriangles, &this->SettingUp })
  {
    layer.Prepare(*program);
    DispatchIndirect(this->WorkGroups, 0);
  }
  if (this->InTiles)
  {
    this->BentCasters.Bind(TileCovers::BentUnit);
    this->Covers.Bind(TileCovers::CoversUnit);
    this->Tiles.Find(
      clusters, most, layer.Table, [&](const Program& program) { layer.Prepare(program); });
  }
}

void CasterDrawing::DrawTriangles(const CasterLayer& layer, int clusters)
{
  layer.Prepare(this->Bent);
  // The covers that tiles make, but for points, are all in the first cluster's draw.
  this->Pulled.DrawIndirect(
    Primitive::Triangles, this->Work, BentDrawOffset, this->InTiles ? 1 : clusters, WorkBytes);
  if (this->InTiles)
  {
    this->Tiles.DrawPoints([&](const Program& program) { layer.Prepare(program); });
  }
  if (layer.Bends == Bending::Tessellated)
  {
    layer.Prepare(this->Patches);
    for (std::size_t k = 0; k < PatchClasses; ++k)
    {
      this->Patches.Set("rtwPatchClass", static_cast<int>(k));
      this->Pulled.DrawIndirect(
        Primitive::Triangles, this->Work, PatchDrawOffset + 16 * k, clusters, WorkBytes);
    }
  }
  layer.Prepare(this->Plane);
  this->Pulled.DrawIndirect(Primitive::Triangles, this->Work, PlaneDrawOffset, clusters, WorkBytes);
  this->Straight.Use();
  this->Pulled.DrawIndirect(Primitive::Triangles, this->Work, 0, clusters, WorkBytes);
}

void CasterDrawing::Draw(const GeometryStore& store, const LayerTable& table,
  const LightFrame& frame, int index, const CasterOptions& options, const DeepestSamples* deepest)
{
  if (store.GetInstances().empty())
  {
    return;
  }
  store.Face(frame.Light.GetOrigin());
  const CasterLayer layer{ store, table, frame, index, options.Cull, this->BendingOf(options),
    options.EdgeLength, deepest };
  this->Clusters.Cull(layer);
  const int most =
    std::min(this->InTiles ? MostClustersInTiles : MostClusters, store.GetNumberOfDraws());
  for (int first = 0; first < store.GetNumberOfDraws(); first += most)
  {
    this->Start(layer, first, most);
    this->SetUp(layer, most);
    this->DrawTriangles(layer, most);
  }
}

void CasterDrawing::Dispose(Disposal dispose)
{
  dispose(this->Programs(), this->Buffers(), this->Clusters, this->BentCasters, this->Covers,
    this->Tiles, this->Pulled);
}
}
