// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwViewSampler.h"

#include "Frame/rtwClusterDraw.h"
#include "Frame/rtwCullView.h"
#include "Frame/rtwFramedView.h"
#include "Frame/rtwGeometryStore.h"
#include "Frame/rtwPrimeDepthFS.h"
#include "Frame/rtwResampleFS.h"
#include "Frame/rtwResolveFS.h"
#include "Frame/rtwSampleDepth.h"
#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampleFS.h"
#include "Frame/rtwViewSampleVS.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwScreenVS.h"
#include "GL/rtwStateGuard.h"

#include <algorithm>

namespace rtw
{
namespace
{
constexpr int ManyUnit = 4;
}

bool ViewSampler::Build()
{
  return this->Culling.Build({ { GL_COMPUTE_SHADER, { rtwClusterDraw, rtwCullView } } }) &&
    this->Drawing.Build(
      { { GL_VERTEX_SHADER, { rtwViewSampleVS } }, { GL_FRAGMENT_SHADER, { rtwViewSampleFS } } }) &&
    this->Priming.Build({ { GL_VERTEX_SHADER, { rtwScreenVS } },
      { GL_FRAGMENT_SHADER, { rtwViewSampleAccess, rtwSampleDepth, rtwPrimeDepthFS } } }) &&
    this->Resampling.Build({ { GL_VERTEX_SHADER, { rtwScreenVS } },
      { GL_FRAGMENT_SHADER, { rtwSamplePlace, rtwResampleFS } } }) &&
    this->Resolving.Build(
      { { GL_VERTEX_SHADER, { rtwScreenVS } }, { GL_FRAGMENT_SHADER, { rtwResolveFS } } });
}

std::string ViewSampler::GetLog() const
{
  return this->Culling.GetLog() + this->Drawing.GetLog() + this->Priming.GetLog() +
    this->Resampling.GetLog() + this->Resolving.GetLog();
}

void ViewSampler::Cull(const GeometryStore& store, bool receiving)
{
  this->Commands.Reserve(store.GetNumberOfDraws() * sizeof(DrawCommand));
  this->Culling.Use();
  store.GetClusters().BindStorage(0);
  store.GetDraws().BindStorage(1);
  this->Matrices.BindStorage(2);
  this->Commands.BindStorage(3);
  this->Culling.Set("rtwNumberOfDraws", store.GetNumberOfDraws());
  this->Culling.Set("rtwWanted",
    static_cast<int>(receiving ? ClusterDraw::ReceivesBit : ClusterDraw::HidesBit));
  Dispatch(Groups(store.GetNumberOfDraws(), 64));
}

void ViewSampler::Allocate(int samples)
{
  const int width = this->Viewed.Width, height = this->Viewed.Height;
  this->Samples.Allocate(Format::Float4, width, height);
  if (samples > 1)
  {
    this->Depth.AllocateSamples(Format::Depth, width, height, samples);
    this->Many.AllocateSamples(Format::Float4, width, height, samples);
  }
  else
  {
    this->Depth.Allocate(Format::Depth, width, height);
    this->Many.Release();
  }
}

// Finds where the samples of the bound target lie in a pixel.
void ViewSampler::FindOffsets(int samples)
{
  this->Offsets.assign(static_cast<std::size_t>(std::max(samples, 1)), glm::vec2(0));
  for (int i = 0; i < samples && samples > 1; ++i)
  {
    float place[2] = { 0.5f, 0.5f };
    glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), place);
    this->Offsets[i] = glm::vec2(place[0], place[1]) - 0.5f;
  }
}

bool ViewSampler::Render(const View& view, const GeometryStore& store, bool own, int samples)
{
  this->Viewed = view;
  this->Current = &this->Samples;
  this->Allocate(samples);
  if (own)
  {
    std::vector<glm::mat4> matrices;
    for (const Instance& instance : store.GetInstances())
    {
      matrices.emplace_back(view.ViewToClip * (view.WorldToView * instance.ToWorld));
    }
    this->Matrices.Assign(matrices);
  }
  if (!this->BindTarget())
  {
    return false;
  }
  this->FindOffsets(samples);
  Framebuffer::Clear(0);
  if (own && !store.GetInstances().empty())
  {
    this->Draw(store, true);
    if (store.HasHiding())
    {
      this->Draw(store, false);
    }
    this->DrawThin(store);
  }
  return true;
}

bool ViewSampler::Resample(const LastFrame& frame, int stride)
{
  this->Viewed = frame.GetView();
  this->Viewed.Width = Groups(this->Viewed.Width, stride);
  this->Viewed.Height = Groups(this->Viewed.Height, stride);
  this->Current = &this->Resampled;
  this->Resampled.Allocate(Format::Float4, this->Viewed.Width, this->Viewed.Height);
  StateGuard::PrepareDepthDrawing(false);
  if (!this->ScreenTarget.BindColour(this->Resampled))
  {
    return false;
  }
  const glm::dvec2 toSample = DepthToSample(this->Viewed);
  this->Resampling.Use();
  frame.GetDepth().Bind(0);
  this->Resampling.Set("rtwDepth", 0);
  this->Resampling.Set("rtwStride", stride);
  this->Resampling.Set("rtwDepthToSample", float(toSample.x), float(toSample.y));
  this->Triangle.Draw();
  return true;
}

void ViewSampler::Draw(const GeometryStore& store, bool receiving)
{
  this->Cull(store, receiving);
  this->Drawing.Use();
  this->Drawing.Set("rtwFramed", this->Viewed.Framed || this->Viewed.Parallel ? 1 : 0);
  this->Drawing.Set("rtwReceiving", receiving ? 1.f : 0.f);
  this->Array.Bind(store.GetPoints(), store.GetIndices(), this->Matrices);
  this->Array.DrawIndirect(this->Commands, store.GetNumberOfDraws());
}

// Lines and vertices have no side to be lit on.
void ViewSampler::DrawThin(const GeometryStore& store)
{
  this->Drawing.Set("rtwReceiving", 0.f);
  for (const ThinDraw& draw : store.GetThinDraws())
  {
    const Instance& instance = store.GetInstances()[draw.Command.BaseInstance];
    if (instance.Receives || instance.Hides)
    {
      this->Array.Draw(draw.Kind, draw.Command);
    }
  }
}

bool ViewSampler::BindTarget()
{
  StateGuard::PrepareDepthDrawing(false);
  if (this->Many.GetId())
  {
    SetEnabled(GL_MULTISAMPLE, true);
  }
  return this->Target.Bind(this->Depth, this->Many.GetId() ? &this->Many : &this->Samples);
}

void ViewSampler::Finish()
{
  if (this->GetSamplesAPixel() > 1 && this->ScreenTarget.BindColour(this->Samples))
  {
    this->Resolving.Use();
    this->Many.Bind(0);
    this->Resolving.Set("rtwManySamples", 0);
    this->Resolving.Set("rtwSamplesAPixel", this->GetSamplesAPixel());
    glUniform2fv(
      this->Resolving.Location("rtwOffsets"), this->GetSamplesAPixel(), &this->Offsets.front().x);
    this->Triangle.Draw();
  }
}

void ViewSampler::PrimeDepth(double farther)
{
  this->Priming.Use();
  this->Bind(this->Priming);
  this->BindDepth(this->Priming, farther);
  this->Triangle.DrawDepth();
}

void ViewSampler::BindDepth(const Program& program, double farther) const
{
  constexpr float share = 1e-3f;
  constexpr double rounding = 5e-7; // rounding of the picture's depth, some steps of 24 bits
  const glm::dvec2 back = DepthToSample(this->Viewed);
  const double way = farther < 0 ? -1 : 1;
  glUniform2i(program.Location("rtwOrigin"), this->Viewed.OriginX, this->Viewed.OriginY);
  program.Set("rtwSampleToDepth", float(1 / back.x), float(-back.y / back.x + way * rounding));
  program.Set("rtwFarther", float(way) * share, float(farther));
  program.Set("rtwFramed", this->Viewed.Framed || this->Viewed.Parallel ? 1 : 0);
}

void ViewSampler::Bind(const Program& program) const
{
  this->Current->Bind(0);
  program.Set("rtwSamples", 0);
  if (this->Many.GetId())
  {
    this->Many.Bind(ManyUnit);
    program.Set("rtwManySamples", ManyUnit);
  }
  const glm::vec4 ray(RayOf(this->Viewed)), place(PlaceOf(this->Viewed));
  glUniform4f(program.Location("rtwRay"), ray.x, ray.y, ray.z, ray.w);
  glUniform4f(program.Location("rtwOfSample"), place.x, place.y, place.z, place.w);
  const glm::vec2 shear(ShearOf(this->Viewed));
  program.Set("rtwShear", shear.x, shear.y);
  const glm::vec3 from(SeenFrom(this->Viewed));
  glUniform4f(
    program.Location("rtwViewer"), from.x, from.y, from.z, this->Viewed.Parallel ? 0.f : 1.f);
  program.Set("rtwViewBegin", float(this->Viewed.Begin));
}

std::size_t ViewSampler::GetMemory() const
{
  return this->Depth.GetMemory() + this->Samples.GetMemory() + this->Many.GetMemory() +
    this->Resampled.GetMemory();
}

void ViewSampler::Dispose(Disposal dispose)
{
  dispose(this->Depth, this->Samples, this->Resampled, this->Many, this->Resampling,
    this->Resolving, this->ScreenTarget, this->Target, this->Culling, this->Drawing, this->Matrices,
    this->Commands, this->Array, this->Priming, this->Triangle);
}
}
