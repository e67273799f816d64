// SPDX-License-Identifier: BSD-3-Clause
// Tests every triangle against the view samples that it may shadow: clusters, then triangles are
// culled by what the grid holds, the rest go down its squares step by step, to a few samples that
// are tested one by one.
#ifndef rtwExactCasting_h
#define rtwExactCasting_h

#include "GL/rtwBuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwReadback.h"
#include "GL/rtwResources.h"
#include "Layers/rtwLayerTable.h"
#include "LightPass/rtwCasterLayer.h"
#include "Warp/rtwWarpStage.h"

#include <array>
#include <cstddef>
#include <string>

namespace rtw
{
class GeometryStore;
class SampleGrid;
struct View;

struct ExactJob
{
  const GeometryStore& Store;
  const LayerTable& Table;
  const LightFrame& Frame;
  const View& Viewed;
  int Layer;
  double SceneSize;
  bool Cull;
};

class ExactCasting
{
public:
  static constexpr unsigned int QueueBinding = 6; // the binding of Queue in rtwExactQueue.glsl

  /// Compiles for that warp; false, with the reason in GetLog(), where the driver can't.
  bool Build(const WarpShape& warp, TableAccess access);
  std::string GetLog() const;
  /// How many items each part of the queue holds, at least 64; more are taken for the most.
  void SetCapacity(std::size_t items);
  std::size_t GetCapacity() const { return this->Capacity; }
  /// Forgets what it counted, and that anything was left out.
  void StartFrame(int layers);
  /// Finds what is in shadow.
  void Cast(const ExactJob& job, SampleGrid& grid);
  /// Asks the GPU whether anything was left out of the frame, without waiting for it.
  void FinishFrame();
  /// Whether it is known by now that something was left out; true only once.
  bool HasOverflowed();
  void BindQueue() const { this->Queue.BindStorage(QueueBinding); }
  /// The clusters of a layer that were drawn and culled in the last frame. Waits for the GPU.
  CasterCounts ReadCounts(int layer) const;
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  std::array<Program*, 4> Programs();
  std::array<const Program*, 4> Programs() const;
  std::array<Buffer*, 7> Buffers();
  std::array<const Buffer*, 7> Buffers() const;
  void PlaceMeshes(const ExactJob& job);
  void Prepare(const Program& program, const ExactJob& job, const SampleGrid& grid) const;
  void CastClusters(const ExactJob& job, const SampleGrid& grid, int first, int end);
  void Descend(const ExactJob& job, const SampleGrid& grid);

  std::string Warp;
  TableAccess Access = TableAccess::Storage;
  std::size_t Capacity = std::size_t(1) << 19;
  Program Culling, SettingUp, Descending, Testing;
  Buffer Boxes, Meshes, Kept, Casters, Queue, Empty, Counts;
  Readback Flag;
};
}

#endif
