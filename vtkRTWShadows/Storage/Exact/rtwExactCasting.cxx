// SPDX-License-Identifier: BSD-3-Clause
#include "Storage/Exact/rtwExactCasting.h"

#include "Frame/rtwClusterDraw.h"
#include "Frame/rtwGeometryStore.h"
#include "Frame/rtwView.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwWarpFocus.h"
#include "Storage/Exact/rtwExactCaster.h"
#include "Storage/Exact/rtwExactCull.h"
#include "Storage/Exact/rtwExactDescend.h"
#include "Storage/Exact/rtwExactQueue.h"
#include "Storage/Exact/rtwExactSetUp.h"
#include "Storage/Exact/rtwExactStart.h"
#include "Storage/Exact/rtwExactState.h"
#include "Storage/Exact/rtwExactTest.h"
#include "Storage/Exact/rtwSampleGrid.h"
#include "Storage/Exact/rtwSampleGridAccess.h"
#include "Storage/Exact/rtwSampleNormal.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rtw
{
namespace
{
constexpr double Rounding = 1e-6; // share of the scene's size

constexpr int ClustersAtATime = 256;
constexpr std::size_t CasterBytes = 48;
constexpr std::size_t MostCasters = 2 * ClustersAtATime * MeshCluster::MaximumTriangles;
constexpr std::size_t MostItems = 65535 * 64; // the most items of a dispatch
// Sizes and places in the queue of rtwExactQueue.glsl, in bytes.
constexpr std::size_t StepBytes = 16;
constexpr std::size_t TestStep = 16, ClusterStep = 17;
constexpr std::size_t OverflowAt = 79;
constexpr std::size_t QueueStart = 80;
}

std::array<Program*, 4> ExactCasting::Programs()
{
  return { &this->Culling, &this->SettingUp, &this->Descending, &this->Testing };
}

std::array<const Program*, 4> ExactCasting::Programs() const
{
  return { &this->Culling, &this->SettingUp, &this->Descending, &this->Testing };
}

std::array<Buffer*, 7> ExactCasting::Buffers()
{
  return { &this->Boxes, &this->Meshes, &this->Kept, &this->Casters, &this->Queue, &this->Empty,
    &this->Counts };
}

std::array<const Buffer*, 7> ExactCasting::Buffers() const
{
  return { &this->Boxes, &this->Meshes, &this->Kept, &this->Casters, &this->Queue, &this->Empty,
    &this->Counts };
}

bool ExactCasting::Build(const WarpShape& warp, TableAccess access)
{
  if (this->Warp != warp.Name || this->Access != access)
  {
    this->Culling.Release();
    this->SettingUp.Release();
    this->Warp = warp.Name;
    this->Access = access;
  }
  const char* const stored = LayerTable::DefinitionOf(access);
  return this->Culling.Build({ { GL_COMPUTE_SHADER,
           { stored, rtwWarpFocus, warp.Function, warp.Bend, rtwClusterDraw, rtwSampleGridAccess,
             rtwExactQueue, rtwExactStart, rtwExactCull } } }) &&
    this->SettingUp.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, rtwSampleGridAccess, rtwExactQueue,
        rtwExactStart, rtwExactCaster, rtwExactSetUp } } }) &&
    this->Descending.Build({ { GL_COMPUTE_SHADER,
      { rtwSampleGridAccess, rtwExactQueue, rtwExactCaster, rtwExactDescend } } }) &&
    this->Testing.Build({ { GL_COMPUTE_SHADER,
      { rtwSampleGridAccess, rtwExactQueue, rtwExactCaster, rtwExactState, rtwSampleNormal,
        rtwExactTest } } });
}

std::string ExactCasting::GetLog() const
{
  std::string log;
  for (const Program* program : this->Programs())
  {
    log += program->GetLog();
  }
  return log;
}

void ExactCasting::SetCapacity(std::size_t items)
{
  this->Capacity = std::clamp<std::size_t>(items, 64, MostItems);
}

void ExactCasting::StartFrame(int layers)
{
  const std::size_t bytes = 4 * (QueueStart + 2 * 3 * this->Capacity);
  if (this->Queue.GetSize() != bytes)
  {
    this->Queue.Release();
    this->Queue.Reserve(bytes);
  }
  std::vector<std::uint32_t> header(QueueStart, 0);
  for (std::size_t step = 0; step <= ClusterStep; ++step)
  {
    header[4 * step + 1] = header[4 * step + 2] = 1;
  }
  this->Empty.Assign(header);
  this->Queue.Write(0, header.data(), 4 * header.size());
  this->Kept.Reserve(16 * ClustersAtATime);
  this->Casters.Reserve(CasterBytes * MostCasters);
  this->Counts.Reserve(8 * static_cast<std::size_t>(layers));
  this->Counts.Clear();
}

void ExactCasting::PlaceMeshes(const ExactJob& job)
{
  std::vector<glm::mat4> boxes;
  std::vector<glm::dmat4> meshes;
  const glm::dmat4 toPlane = WorldToExactPlane(job.Frame, job.Viewed.Origin);
  for (const Instance& instance : job.Store.GetInstances())
  {
    meshes.push_back(toPlane * instance.ToWorld);
    boxes.emplace_back(meshes.back());
  }
  this->Boxes.Assign(boxes);
  this->Meshes.Assign(meshes);
}

void ExactCasting::Prepare(
  const Program& program, const ExactJob& job, const SampleGrid& grid) const
{
  program.Use();
  job.Table.Bind(program);
  job.Table.BindLayer(job.Layer);
  grid.Bind(program);
  this->BindQueue();
  program.Set("rtwQueueCapacity", static_cast<int>(this->Capacity));
  program.Set("rtwLayer", job.Layer);
  program.Set("rtwNearestW", NearestW(job.Frame));
}

void ExactCasting::CastClusters(const ExactJob& job, const SampleGrid& grid, int first, int end)
{
  // Everything is reset but whether anything was left out.
  this->Queue.Copy(0, this->Empty, 0, 4 * OverflowAt);
  this->Prepare(this->Culling, job, grid);
  job.Store.GetClusters().BindStorage(0);
  job.Store.GetDraws().BindStorage(1);
  this->Boxes.BindStorage(2);
  this->Kept.BindStorage(4);
  this->Counts.BindStorage(5);
  this->Culling.Set("rtwFirstDraw", first);
  this->Culling.Set("rtwEndDraw", end);
  this->Culling.Set("rtwCull", job.Cull ? 1 : 0);
  this->Culling.Set("rtwRounding", float(Rounding * job.SceneSize));
  this->Culling.Set("rtwReference", float(ExactReference(job.Frame, job.Viewed.Origin)));
  Dispatch(Groups(end - first, 64));

  this->Prepare(this->SettingUp, job, grid);
  job.Store.GetPoints().BindStorage(0);
  job.Store.GetIndices().BindStorage(1);
  this->Meshes.BindStorage(2);
  this->Casters.BindStorage(5);
  this->SettingUp.Set("rtwCasterCapacity", static_cast<int>(MostCasters));
  DispatchIndirect(this->Queue, ClusterStep * StepBytes);
}

void ExactCasting::Descend(const ExactJob& job, const SampleGrid& grid)
{
  this->Prepare(this->Descending, job, grid);
  for (int step = 0; step < grid.GetTopLevel(); ++step)
  {
    this->Descending.Set("rtwStep", step);
    DispatchIndirect(this->Queue, step * StepBytes);
  }
  this->Prepare(this->Testing, job, grid);
  // The view's origin, from where light-plane coordinates go unless that lies beside or behind a
  // spot.
  const double reference = ExactReference(job.Frame, job.Viewed.Origin);
  const glm::dvec4 origin =
    WorldToExactPlane(job.Frame, job.Viewed.Origin) * glm::dvec4(job.Viewed.Origin, 1);
  this->Testing.Set("rtwFrom", float(origin.x), float(origin.y),
    float(reference > 0 ? origin.w - reference : origin.z));
  this->Testing.Set("rtwReference", float(reference));
  grid.BindList(0, 1);
  grid.BindStates();
  DispatchIndirect(this->Queue, TestStep * StepBytes);
}

void ExactCasting::Cast(const ExactJob& job, SampleGrid& grid)
{
  if (job.Store.GetInstances().empty())
  {
    return;
  }
  job.Store.Face(job.Frame.Light.GetOrigin());
  this->PlaceMeshes(job);
  int batch = 0;
  for (int first = 0; first < job.Store.GetNumberOfDraws(); first += ClustersAtATime, ++batch)
  {
    const int end = std::min(first + ClustersAtATime, job.Store.GetNumberOfDraws());
    this->CastClusters(job, grid, first, end);
    this->Descend(job, grid);
    // Samples that are in shadow by now need no more casters.
    if (end < job.Store.GetNumberOfDraws() && (batch & (batch + 1)) == 0)
    {
      grid.Bound();
    }
  }
}

void ExactCasting::FinishFrame()
{
  this->Flag.Start(this->Queue, 4 * QueueStart);
}

bool ExactCasting::HasOverflowed()
{
  std::uint32_t header[QueueStart] = {};
  return this->Flag.IsUnderWay() && this->Flag.IsReady() && this->Flag.Read(header) &&
    header[OverflowAt] != 0;
}

CasterCounts ExactCasting::ReadCounts(int layer) const
{
  CasterCounts counts;
  if ((layer + 1) * sizeof(counts) <= this->Counts.GetSize())
  {
    this->Counts.Read(layer * sizeof(counts), &counts, sizeof(counts));
  }
  return counts;
}

std::size_t ExactCasting::GetMemory() const
{
  std::size_t memory = 0;
  for (const Buffer* buffer : this->Buffers())
  {
    memory += buffer->GetSize();
  }
  return memory;
}

void ExactCasting::Dispose(Disposal dispose)
{
  dispose(this->Programs(), this->Buffers(), this->Flag);
}
}
