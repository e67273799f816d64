// SPDX-License-Identifier: BSD-3-Clause
#include "LightPass/Culling/rtwCasterCulling.h"

#include "Frame/rtwClusterDraw.h"
#include "Frame/rtwGeometryStore.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwWarpFocus.h"
#include "LightPass/Culling/rtwCullCasters.h"
#include "LightPass/Culling/rtwDeepest.h"
#include "LightPass/Culling/rtwDeepestIn.h"
#include "LightPass/Culling/rtwFocusMatrices.h"
#include "LightPass/Culling/rtwListClusters.h"

#include <cstdint>
#include <vector>

namespace rtw
{
namespace
{
constexpr std::size_t HeaderBytes = 8, ListedBytes = 8; // sizes of the list of rtwListClusters.glsl
}

std::array<Buffer*, 5> CasterCulling::Buffers()
{
  return { &this->LightMatrices, &this->Matrices, &this->Bent, &this->List, &this->Counts };
}

bool CasterCulling::Build(const WarpShape& warp, TableAccess access)
{
  const char* const stored = LayerTable::DefinitionOf(access);
  return this->Focusing.Build(
           { { GL_COMPUTE_SHADER, { stored, rtwWarpFocus, rtwFocusMatrices } } }) &&
    this->Culling.Build({ { GL_COMPUTE_SHADER,
      { stored, rtwWarpFocus, warp.Function, warp.Bend, rtwClusterDraw, rtwDeepest, rtwDeepestIn,
        rtwCullCasters } } }) &&
    this->Listing.Build({ { GL_COMPUTE_SHADER, { rtwListClusters } } });
}

std::string CasterCulling::GetLog() const
{
  return this->Focusing.GetLog() + this->Culling.GetLog() + this->Listing.GetLog();
}

std::size_t CasterCulling::GetMemory() const
{
  return this->LightMatrices.GetSize() + this->Matrices.GetSize() + this->Bent.GetSize() +
    this->List.GetSize();
}

void CasterCulling::StartLayer(int layer)
{
  const CasterCounts none;
  this->Counts.Reserve((layer + 1) * sizeof(none), true);
  this->Counts.Write(layer * sizeof(none), &none, sizeof(none));
}

void CasterCulling::Focus(const CasterLayer& layer)
{
  std::vector<glm::mat4> matrices;
  for (const Instance& instance : layer.Store.GetInstances())
  {
    matrices.emplace_back(layer.Frame.WorldToLight * instance.ToWorld);
  }
  this->LightMatrices.Assign(matrices);
  this->Matrices.Reserve(matrices.size() * sizeof(glm::mat4));
  layer.Prepare(this->Focusing);
  this->LightMatrices.BindStorage(0);
  this->Matrices.BindStorage(1);
  this->Focusing.Set("rtwNumberOfInstances", static_cast<int>(matrices.size()));
  Dispatch(Groups(static_cast<int>(matrices.size()), 64));
}

void CasterCulling::Cull(const CasterLayer& layer)
{
  this->Focus(layer);
  const int draws = layer.Store.GetNumberOfDraws();
  this->Bent.Reserve(sizeof(std::uint32_t) * draws);
  this->List.Reserve(HeaderBytes + ListedBytes * draws);
  layer.Prepare(this->Culling);
  layer.Store.GetClusters().BindStorage(0);
  layer.Store.GetDraws().BindStorage(1);
  this->Matrices.BindStorage(2);
  this->Bent.BindStorage(3);
  this->List.BindStorage(4);
  this->Counts.BindStorage(5);
  this->Culling.Set("rtwNumberOfDraws", draws);
  this->Culling.Set("rtwCull", layer.Cull ? 1 : 0);
  this->Culling.Set("rtwBending", layer.Bends != Bending::Linear ? 1 : 0);
  this->Culling.Set("rtwLeastBend", layer.LeastBend());
  Dispatch(Groups(draws, 64));
  this->Listing.Use();
  this->Listing.Set("rtwNumberOfDraws", draws);
  Dispatch(1);
}

CasterCounts CasterCulling::ReadCounts(int layer) const
{
  CasterCounts counts;
  if ((layer + 1) * sizeof(counts) <= this->Counts.GetSize())
  {
    this->Counts.Read(layer * sizeof(counts), &counts, sizeof(counts));
  }
  return counts;
}

void CasterCulling::Dispose(Disposal dispose)
{
  dispose(this->Programs(), this->Buffers());
}
}
