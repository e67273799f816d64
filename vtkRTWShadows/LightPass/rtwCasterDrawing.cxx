// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCasterDrawing.h"

#include "rtwBentCasterFS.h"
#include "rtwBentCasterVS.h"
#include "rtwCasterCovers.h"
#include "rtwCasterGradient.h"
#include "rtwCasterPlane.h"
#include "rtwCasterRecords.h"
#include "rtwCasterTriangle.h"
#include "rtwCasterWork.h"
#include "rtwClusterDraw.h"
#include "rtwCoverByTiles.h"
#include "rtwCoverCasters.h"
#include "rtwCoveredCaster.h"
#include "rtwCoverInFront.h"
#include "rtwCullCasters.h"
#include "rtwCullTriangles.h"
#include "rtwDeepest.h"
#include "rtwDeepestIn.h"
#include "rtwDeepestSamples.h"
#include "rtwFocusMatrices.h"
#include "rtwGeometryStore.h"
#include "rtwOpenGL.h"
#include "rtwPatchClasses.h"
#include "rtwSetUpCasters.h"
#include "rtwStraightCasterFS.h"
#include "rtwStraightCasterVS.h"
#include "rtwTessellateCasters.h"
#include "rtwTessellatedCasterFS.h"
#include "rtwTessellatedCasterVS.h"
#include "rtwThinCasterFS.h"
#include "rtwThinCasterVS.h"
#include "rtwWarpFocus.h"

#include <algorithm>
#include <vector>

namespace rtw
{
namespace
{
// Half of a quarter of a texel, which can be seen.
constexpr float AllowedBendInTexels = 0.125f;
// What is bent less than that is straight whatever its slope.
constexpr float LeastBendInTexels = 0.005f;
// Of the distance at which a spot's depths start: what is nearer is part of the lamp.
constexpr double NearestWShare = 0.01;

constexpr std::size_t MostTriangles = MeshCluster::MaximumTriangles;
// Of patches, themselves triangles of 1, 2, 4, 8 and 16 pieces along an edge at most.
constexpr std::size_t PatchClasses = 5;
// What the shaders keep of a cluster, by the rules of std430.
constexpr std::size_t WorkBytes = 64 + 16 * PatchClasses + 4 * MostTriangles;
constexpr std::size_t StraightBytes = 48 * MostTriangles;
constexpr std::size_t BentBytes = 128 * MostTriangles;
constexpr std::size_t CoverBytes = 32;
// What is set up at a time, so that the memory which that takes is bounded.
constexpr int MostClusters = 128;
constexpr std::size_t MostCovers = 3072; // of a cluster
// Tiles have the room of all together, and some clusters' few large triangles need thousands.
constexpr int MostClustersInTiles = 32;
constexpr std::size_t FinePatches =
  (PatchClasses - 1) * MostTriangles;      // of all classes but the last
constexpr std::size_t BentDrawOffset = 16; // in a cluster's work
constexpr std::size_t PatchDrawOffset = 32;

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

float NearestW(const LightFrame& frame)
{
  return frame.Light.Kind == LightKind::Spot ? float(NearestWShare * frame.NearestDistance) : 0.5f;
}
}

std::array<Program*, 8> CasterDrawing::Programs()
{
  return { &this->Focusing, &this->Culling, &this->CullingTriangles, &this->SettingUp,
    &this->Straight, &this->Bent, &this->Patches, &this->Thin };
}

std::array<Buffer*, 7> CasterDrawing::Buffers()
{
  return { &this->LightMatrices, &this->Matrices, &this->Work, &this->StraightCasters,
    &this->BentCasters, &this->Covers, &this->Counts };
}

bool CasterDrawing::Build(const WarpShape& warp, TableAccess access)
{
  if (this->Warp != warp.Name || this->Access != access)
  {
    for (Program* program : this->Programs())
    {
      program->Release();
    }
    this->Tiles.Release();
    this->Warp = warp.Name;
    this->Access = access;
  }
  this->InTiles = warp.Kind == WarpKind::Grid;
  this->Projective = warp.Kind == WarpKind::Projective;
  const std::string limits = Limits();
  const char* const stored = WarpTable::DefinitionOf(access);
  const char* const cover = CoverOf(warp.Kind);
  // Where edges are straight, a cover is the triangle.
  const char* const covered = this->Projective ? rtwTessellatedCasterFS : rtwBentCasterFS;
  return this->Focusing.Build(
           { { GL_COMPUTE_SHADER, { stored, rtwWarpFocus, rtwFocusMatrices } } }) &&
    this->Culling.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, rtwClusterDraw, limits.c_str(),
        rtwPatchClasses, rtwCasterWork, rtwDeepest, rtwDeepestIn, rtwCullCasters } } }) &&
    this->CullingTriangles.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, limits.c_str(), rtwCasterWork,
        rtwCasterTriangle, rtwDeepest, rtwDeepestIn, rtwCullTriangles } } }) &&
    this->SettingUp.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, limits.c_str(), rtwCasterWork,
        rtwCasterTriangle, rtwCasterRecords, rtwPatchClasses, rtwCasterCovers, cover,
        rtwTessellateCasters, rtwSetUpCasters } } }) &&
    this->Straight.Build({ { GL_VERTEX_SHADER, { rtwCasterRecords, rtwStraightCasterVS } },
      { GL_FRAGMENT_SHADER, { rtwCasterGradient, rtwStraightCasterFS } } }) &&
    this->Bent.Build({ { GL_VERTEX_SHADER,
                         { rtwCasterRecords, rtwCoveredCaster, rtwBentCasterVS } },
      { GL_FRAGMENT_SHADER,
        { stored, rtwWarpFocus, warp.Function, rtwCasterGradient, rtwCasterPlane, covered } } }) &&
    this->Patches.Build({ { GL_VERTEX_SHADER,
                            { stored, rtwWarpFocus, warp.Function, limits.c_str(), rtwPatchClasses,
                              rtwCasterRecords, rtwTessellatedCasterVS } },
      { GL_FRAGMENT_SHADER,
        { stored, rtwWarpFocus, warp.Function, rtwCasterGradient, rtwCasterPlane,
          rtwTessellatedCasterFS } } }) &&
    this->Thin.Build(
      { { GL_VERTEX_SHADER, { stored, rtwWarpFocus, warp.Function, rtwThinCasterVS } },
        { GL_FRAGMENT_SHADER, { rtwThinCasterFS } } }) &&
    (!this->InTiles || this->Tiles.Build(warp, access, limits));
}

std::string CasterDrawing::GetLog() const
{
  return this->Focusing.GetLog() + this->Culling.GetLog() + this->CullingTriangles.GetLog() +
    this->SettingUp.GetLog() + this->Straight.GetLog() + this->Bent.GetLog() +
    this->Patches.GetLog() + this->Thin.GetLog() + this->Tiles.GetLog();
}

std::size_t CasterDrawing::GetMemory() const
{
  return this->LightMatrices.GetSize() + this->Matrices.GetSize() + this->Work.GetSize() +
    this->StraightCasters.GetSize() + this->BentCasters.GetSize() + this->Covers.GetSize() +
    this->Tiles.GetMemory();
}

void CasterDrawing::StartLayer(int layer)
{
  const CasterCounts none;
  this->Counts.Reserve((layer + 1) * sizeof(none), true);
  this->Counts.Write(layer * sizeof(none), &none, sizeof(none));
}

// Straight edges need none of the other ways.
Bending CasterDrawing::BendingOf(const Layer& layer) const
{
  return this->Projective ? Bending::Exact : layer.Options.Bends;
}

void CasterDrawing::Prepare(const Program& program, const Layer& layer) const
{
  program.Use();
  layer.Table.Bind(program);
  layer.Table.BindLayer(layer.Index);
  DeepestSamples::Bind(program, layer.Deepest);
  program.Set("rtwLayer", layer.Index);
  program.Set("rtwNearestW", NearestW(layer.Frame));
  const Bending bends = this->BendingOf(layer);
  const float allowed = bends == Bending::Exact ? LeastBendInTexels : AllowedBendInTexels;
  program.Set("rtwAllowedBend", allowed / float(layer.Table.GetResolution()));
  program.Set("rtwTessellating", bends == Bending::Tessellated ? 1 : 0);
  program.Set("rtwEdgeLength", float(layer.Options.EdgeLength));
}

void CasterDrawing::Focus(const Layer& layer)
{
  std::vector<glm::mat4> matrices;
  for (const Instance& instance : layer.Store.GetInstances())
  {
    matrices.emplace_back(layer.Frame.WorldToLight * instance.ToWorld);
  }
  this->LightMatrices.Assign(matrices);
  this->Matrices.Reserve(matrices.size() * sizeof(glm::mat4));
  this->Prepare(this->Focusing, layer);
  this->LightMatrices.BindStorage(0);
  this->Matrices.BindStorage(1);
  this->Focusing.Set("rtwNumberOfInstances", static_cast<int>(matrices.size()));
  Dispatch(Groups(static_cast<int>(matrices.size()), 64));
}

void CasterDrawing::Cull(const Layer& layer, int first, int end)
{
  this->Work.Reserve(WorkBytes * (end - first));
  this->Prepare(this->Culling, layer);
  layer.Store.GetClusters().BindStorage(0);
  layer.Store.GetDraws().BindStorage(1);
  this->Matrices.BindStorage(2);
  this->Work.BindStorage(3);
  this->Counts.BindStorage(5);
  this->Culling.Set("rtwFirstDraw", first);
  this->Culling.Set("rtwEndDraw", end);
  this->Culling.Set("rtwCull", layer.Options.Cull ? 1 : 0);
  this->Culling.Set("rtwBending", this->BendingOf(layer) != Bending::Linear ? 1 : 0);
  this->Culling.Set("rtwLeastBend", LeastBendInTexels / float(layer.Table.GetResolution()));
  Dispatch(Groups(end - first, 64));
}

void CasterDrawing::SetUp(const Layer& layer, int clusters)
{
  this->StraightCasters.Reserve(StraightBytes * clusters);
  this->BentCasters.Reserve(BentBytes * clusters);
  // Patches lie behind the covers.
  const bool tessellates = this->BendingOf(layer) == Bending::Tessellated;
  const std::size_t most = MostClusters * MostCovers;
  this->Covers.Reserve(CoverBytes *
    (tessellates        ? 2 * most + MostClusters * FinePatches
        : this->InTiles ? most
                        : MostCovers * clusters));
  layer.Store.GetPoints().BindStorage(0);
  layer.Store.GetIndices().BindStorage(1);
  this->Matrices.BindStorage(2);
  this->Work.BindStorage(3);
  this->StraightCasters.BindStorage(4);
  this->BentCasters.BindStorage(5);
  this->Covers.BindStorage(6);
  for (const Program* program : { &this->CullingTriangles, &this->SettingUp })
  {
    this->Prepare(*program, layer);
    Dispatch(clusters);
  }
  if (this->InTiles)
  {
    this->Tiles.Find(
      clusters, most, layer.Table, [&](const Program& program) { this->Prepare(program, layer); });
  }
}

void CasterDrawing::DrawTriangles(const Layer& layer, int clusters)
{
  this->Prepare(this->Bent, layer);
  this->Pulled.DrawIndirect(Primitive::Triangles, this->Work, BentDrawOffset, clusters, WorkBytes);
  if (this->InTiles)
  {
    this->Tiles.DrawPoints([&](const Program& program) { this->Prepare(program, layer); });
  }
  if (this->BendingOf(layer) == Bending::Tessellated)
  {
    this->Prepare(this->Patches, layer);
    for (std::size_t k = 0; k < PatchClasses; ++k)
    {
      this->Patches.Set("rtwPatchClass", static_cast<int>(k));
      this->Pulled.DrawIndirect(
        Primitive::Triangles, this->Work, PatchDrawOffset + 16 * k, clusters, WorkBytes);
    }
  }
  this->Straight.Use();
  this->Pulled.DrawIndirect(Primitive::Triangles, this->Work, 0, clusters, WorkBytes);
}

void CasterDrawing::DrawThin(const Layer& layer)
{
  if (layer.Store.GetThinDraws().empty())
  {
    return;
  }
  this->Array.Bind(layer.Store.GetPoints(), layer.Store.GetIndices(), this->Matrices);
  this->Prepare(this->Thin, layer);
  for (const ThinDraw& draw : layer.Store.GetThinDraws())
  {
    if (layer.Store.GetInstances()[draw.Command.BaseInstance].Casts)
    {
      this->Array.Draw(draw.Kind, draw.Command);
    }
  }
}

void CasterDrawing::Draw(const GeometryStore& store, const WarpTable& table,
  const LightFrame& frame, int index, const CasterOptions& options, const DeepestSamples* deepest)
{
  if (store.GetInstances().empty())
  {
    return;
  }
  const Layer layer{ store, table, frame, index, options, deepest };
  this->Focus(layer);
  const int most = this->InTiles ? MostClustersInTiles : MostClusters;
  for (int first = 0; first < store.GetNumberOfDraws(); first += most)
  {
    const int end = std::min(first + most, store.GetNumberOfDraws());
    this->Cull(layer, first, end);
    this->SetUp(layer, end - first);
    this->DrawTriangles(layer, end - first);
  }
  this->DrawThin(layer);
}

CasterCounts CasterDrawing::ReadCounts(int layer) const
{
  CasterCounts counts;
  if ((layer + 1) * sizeof(counts) <= this->Counts.GetSize())
  {
    this->Counts.Read(layer * sizeof(counts), &counts, sizeof(counts));
  }
  return counts;
}

void CasterDrawing::Release()
{
  for (Program* program : this->Programs())
  {
    program->Release();
  }
  for (Buffer* buffer : this->Buffers())
  {
    buffer->Release();
  }
  this->Tiles.Release();
  this->Array.Release();
  this->Pulled.Release();
}

void CasterDrawing::Abandon()
{
  for (Program* program : this->Programs())
  {
    program->Abandon();
  }
  for (Buffer* buffer : this->Buffers())
  {
    buffer->Abandon();
  }
  this->Tiles.Abandon();
  this->Array.Abandon();
  this->Pulled.Abandon();
}
}
