// SPDX-License-Identifier: BSD-3-Clause
#include "rtwViewSampler.h"

#include "rtwClusterDraw.h"
#include "rtwCullView.h"
#include "rtwGeometryStore.h"
#include "rtwOpenGL.h"
#include "rtwStateGuard.h"
#include "rtwViewSampleFS.h"
#include "rtwViewSampleVS.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace rtw
{
bool ViewSampler::Build()
{
  return this->Culling.Build({ { GL_COMPUTE_SHADER, { rtwClusterDraw, rtwCullView } } }) &&
    this->Drawing.Build({ { GL_VERTEX_SHADER, { rtwViewSampleVS } },
      { GL_FRAGMENT_SHADER, { rtwViewSampleFS } } });
}

const std::string& ViewSampler::GetLog() const
{
  return this->Culling.IsBuilt() ? this->Drawing.GetLog() : this->Culling.GetLog();
}

void ViewSampler::Cull(const GeometryStore& store)
{
  this->Commands.Reserve(store.GetNumberOfDraws() * sizeof(DrawCommand));
  this->Culling.Use();
  store.GetClusters().BindStorage(0);
  store.GetDraws().BindStorage(1);
  this->Matrices.BindStorage(2);
  this->Commands.BindStorage(3);
  this->Culling.Set("rtwNumberOfDraws", store.GetNumberOfDraws());
  Dispatch(Groups(store.GetNumberOfDraws(), 64));
}

bool ViewSampler::Render(const View& view, const GeometryStore& store, int stride)
{
  this->Viewed = view;
  this->Stride = stride;
  const int width = std::max(1, view.Width / stride), height = std::max(1, view.Height / stride);
  this->Depth.Allocate(Format::Depth, width, height);
  this->Slope.Allocate(Format::Float2, width, height);
  std::vector<glm::mat4> matrices;
  for (const Instance& instance : store.GetInstances())
  {
    matrices.emplace_back(view.ViewToClip * (view.WorldToView * instance.ToWorld));
  }
  this->Matrices.Assign(matrices);
  this->Cull(store);
  if (!this->BindTarget())
  {
    return false;
  }
  Framebuffer::Clear(0);
  if (store.GetNumberOfDraws() > 0 || !store.GetThinDraws().empty())
  {
    this->Drawing.Use();
    this->Array.Bind(store.GetPoints(), store.GetIndices(), this->Matrices);
    this->Array.DrawIndirect(this->Commands, store.GetNumberOfDraws());
    for (const ThinDraw& draw : store.GetThinDraws())
    {
      if (store.GetInstances()[draw.Command.BaseInstance].Receives)
      {
        this->Array.Draw(draw.Kind, draw.Command);
      }
    }
  }
  return true;
}

bool ViewSampler::BindTarget()
{
  StateGuard::PrepareDepthDrawing(false);
  return this->Target.Bind(this->Depth, &this->Slope);
}

void ViewSampler::Bind(const Program& program) const
{
  const glm::mat4 clipToView(this->Viewed.ClipToView);
  this->Depth.Bind(0);
  this->Slope.Bind(1);
  program.SetMatrix("rtwClipToView", glm::value_ptr(clipToView));
  program.Set("rtwParallel", this->Viewed.Parallel ? 1 : 0);
}

std::size_t ViewSampler::GetMemory() const
{
  return this->Depth.GetMemory() + this->Slope.GetMemory();
}

void ViewSampler::Release()
{
  this->Depth.Release();
  this->Slope.Release();
  this->Target.Release();
  this->Culling.Release();
  this->Drawing.Release();
  this->Matrices.Release();
  this->Commands.Release();
  this->Array.Release();
}

void ViewSampler::Abandon()
{
  this->Depth.Abandon();
  this->Slope.Abandon();
  this->Target.Abandon();
  this->Culling.Abandon();
  this->Drawing.Abandon();
  this->Matrices.Abandon();
  this->Commands.Abandon();
  this->Array.Abandon();
}
}
