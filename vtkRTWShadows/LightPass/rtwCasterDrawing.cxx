// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCasterDrawing.h"

#include "rtwBentCasterFS.h"
#include "rtwBentCasterGS.h"
#include "rtwBentCasterVS.h"
#include "rtwCasterFS.h"
#include "rtwCasterVS.h"
#include "rtwClusterDraw.h"
#include "rtwCullCasters.h"
#include "rtwFocusMatrices.h"
#include "rtwGeometryStore.h"
#include "rtwOpenGL.h"
#include "rtwWarpFocus.h"
#include "rtwWarpTable.h"

#include <algorithm>
#include <vector>

namespace rtw
{
namespace
{
// A quarter of a texel can be seen; half of that is for the gradients that are computed along.
constexpr float AllowedBendInTexels = 0.125f;
// Of the distance at which a spot's depths start: what is nearer is part of the lamp.
constexpr double NearestWShare = 0.01;

float NearestW(const LightFrame& frame)
{
  return frame.Light.Kind == LightKind::Spot ? float(NearestWShare * frame.NearestDistance) : 0.5f;
}
}

bool CasterDrawing::Build(const WarpShape& warp)
{
  if (this->Warp != warp.Name)
  {
    for (Program* program : { &this->Focusing, &this->Culling, &this->Plain, &this->Bent })
    {
      program->Release();
    }
    this->Warp = warp.Name;
  }
  return this->Focusing.Build({ { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwFocusMatrices } } }) &&
    this->Culling.Build(
      { { GL_COMPUTE_SHADER, { rtwWarpFocus, warp.Bend, rtwClusterDraw, rtwCullCasters } } }) &&
    this->Plain.Build({ { GL_VERTEX_SHADER, { rtwWarpFocus, warp.Function, rtwCasterVS } },
      { GL_FRAGMENT_SHADER, { rtwCasterFS } } }) &&
    this->Bent.Build({ { GL_VERTEX_SHADER, { rtwBentCasterVS } },
      { GL_GEOMETRY_SHADER, { rtwWarpFocus, warp.Function, warp.Bend, rtwBentCasterGS } },
      { GL_FRAGMENT_SHADER, { rtwWarpFocus, warp.Function, rtwBentCasterFS } } });
}

std::string CasterDrawing::GetLog() const
{
  return this->Focusing.GetLog() + this->Culling.GetLog() + this->Plain.GetLog() +
    this->Bent.GetLog();
}

void CasterDrawing::StartLayer(int layer)
{
  const CasterCounts none;
  this->Counts.Reserve((layer + 1) * sizeof(none), true);
  this->Counts.Write(layer * sizeof(none), &none, sizeof(none));
}

void CasterDrawing::Focus(
  const GeometryStore& store, const WarpTable& table, const LightFrame& frame, int layer)
{
  std::vector<glm::mat4> matrices;
  for (const Instance& instance : store.GetInstances())
  {
    matrices.emplace_back(frame.WorldToLight * instance.ToWorld);
  }
  this->LightMatrices.Assign(matrices);
  this->Matrices.Reserve(matrices.size() * sizeof(glm::mat4));
  this->Focusing.Use();
  table.Bind(this->Focusing);
  this->LightMatrices.BindStorage(0);
  this->Matrices.BindStorage(1);
  this->Focusing.Set("rtwNumberOfInstances", static_cast<int>(matrices.size()));
  this->Focusing.Set("rtwLayer", layer);
  Dispatch(Groups(static_cast<int>(matrices.size()), 64));
}

void CasterDrawing::Cull(const GeometryStore& store, const WarpTable& table,
  const LightFrame& frame, int layer, const CasterOptions& options)
{
  const int draws = store.GetNumberOfDraws();
  this->Focus(store, table, frame, layer);
  this->BentCommands.Reserve(draws * sizeof(DrawCommand));
  this->PlainCommands.Reserve(draws * sizeof(DrawCommand));
  this->Culling.Use();
  table.Bind(this->Culling);
  store.GetClusters().BindStorage(0);
  store.GetDraws().BindStorage(1);
  this->Matrices.BindStorage(2);
  this->BentCommands.BindStorage(3);
  this->PlainCommands.BindStorage(4);
  this->Counts.BindStorage(5);
  this->Culling.Set("rtwNumberOfDraws", draws);
  this->Culling.Set("rtwLayer", layer);
  this->Culling.Set("rtwCull", options.Cull ? 1 : 0);
  this->Culling.Set("rtwExact", options.Exact ? 1 : 0);
  this->Culling.Set("rtwNearestW", NearestW(frame));
  this->Culling.Set("rtwAllowedBend", AllowedBendInTexels / float(table.GetResolution()));
  Dispatch(Groups(draws, 64));
}

void CasterDrawing::Draw(
  const GeometryStore& store, const WarpTable& table, const LightFrame& frame, int layer)
{
  if (store.GetInstances().empty())
  {
    return;
  }
  this->Array.Bind(store.GetPoints(), store.GetIndices(), this->Matrices);
  this->Bent.Use();
  table.Bind(this->Bent);
  this->Bent.Set("rtwLayer", layer);
  this->Bent.Set("rtwNearestW", NearestW(frame));
  this->Bent.Set("rtwAllowedBend", AllowedBendInTexels / float(table.GetResolution()));
  this->Array.DrawIndirect(this->BentCommands, store.GetNumberOfDraws());
  this->Plain.Use();
  table.Bind(this->Plain);
  this->Plain.Set("rtwLayer", layer);
  this->Array.DrawIndirect(this->PlainCommands, store.GetNumberOfDraws());
  for (const ThinDraw& draw : store.GetThinDraws())
  {
    if (store.GetInstances()[draw.Command.BaseInstance].Casts)
    {
      this->Array.Draw(draw.Kind, draw.Command);
    }
  }
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
  for (Program* program : { &this->Focusing, &this->Culling, &this->Plain, &this->Bent })
  {
    program->Release();
  }
  for (Buffer* buffer : { &this->LightMatrices, &this->Matrices, &this->BentCommands,
         &this->PlainCommands, &this->Counts })
  {
    buffer->Release();
  }
  this->Array.Release();
}

void CasterDrawing::Abandon()
{
  for (Program* program : { &this->Focusing, &this->Culling, &this->Plain, &this->Bent })
  {
    program->Abandon();
  }
  for (Buffer* buffer : { &this->LightMatrices, &this->Matrices, &this->BentCommands,
         &this->PlainCommands, &this->Counts })
  {
    buffer->Abandon();
  }
  this->Array.Abandon();
}
}
