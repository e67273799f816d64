// SPDX-License-Identifier: BSD-3-Clause
#include "Storage/Exact/rtwExactShadows.h"

#include "Frame/rtwFrameScene.h"
#include "Frame/rtwSampleDepth.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwScreenVS.h"
#include "GL/rtwStageTimers.h"
#include "Layers/rtwDenseLayers.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwLightUniforms.h"
#include "Lookup/rtwDebugColours.h"
#include "Lookup/rtwMaskStage.h"
#include "Lookup/rtwMaskValue.h"
#include "Storage/Exact/rtwExactBitsFS.h"
#include "Storage/Exact/rtwExactFailedFS.h"
#include "Storage/Exact/rtwExactListsFS.h"
#include "Storage/Exact/rtwExactMaskFS.h"
#include "Storage/Exact/rtwExactQueue.h"
#include "Storage/Exact/rtwExactState.h"
#include "Storage/Exact/rtwOtherCasters.h"
#include "Storage/Exact/rtwSampleGridAccess.h"

namespace rtw
{
namespace
{
constexpr std::size_t ItemBytes = 3 * 8; // bytes of an item in all parts of the queue together
}

bool ExactShadows::Build(const MaskJob& job)
{
  ReceiverShape one = job.Shape; // each light is drawn by itself, and its own layer isn't looked at
  one.Switched = { 0 };
  one.OtherLayers = false;
  const bool others = job.OtherLayers > 0;
  if (!(one == this->Shape) || this->HasOthers != others)
  {
    this->HasOthers = others;
    this->Resolving.Release();
    this->Separating.Release();
    this->Painting.Release();
    this->Shape = one;
  }
  return this->Grid.Build(one.Warp, job.Access, job.Samples.GetSamplesAPixel() > 1) &&
    this->Casting.Build(one.Warp, job.Access) && this->BuildDrawing(job, one) &&
    this->Failing.Build({ { GL_VERTEX_SHADER, { rtwScreenVS } },
      { GL_FRAGMENT_SHADER, { rtwExactQueue, rtwExactFailedFS } } });
}

bool ExactShadows::BuildDrawing(const MaskJob& job, const ReceiverShape& one)
{
  const std::string definitions = DefinitionsOf(one) +
    (this->HasOthers ? "#define RTW_HAS_OTHERS 1\n" : "#define RTW_HAS_OTHERS 0\n");
  const std::string lookup = LookupCode(one);
  const char* const stored = LayerTable::DefinitionOf(TableAccess::Texels);
  const auto build = [&](Program& program, const char* point, const char* main) {
    return program.Build({ { GL_VERTEX_SHADER, { rtwScreenVS } },
      { GL_FRAGMENT_SHADER,
        { stored, definitions.c_str(), rtwWarpFocus, one.Warp.Function, lookup.c_str(),
          rtwViewSampleAccess, point, rtwMaskValue, rtwExactState, rtwOtherCasters, main } } });
  };
  return build(this->Resolving, "", rtwExactMaskFS) &&
    (job.Samples.GetSamplesAPixel() < 2 ||
      build(this->Separating, PointCode(true), rtwExactBitsFS));
}

std::string ExactShadows::GetLog() const
{
  return this->Grid.GetLog() + this->Casting.GetLog() + this->Resolving.GetLog() +
    this->Separating.GetLog() + this->Failing.GetLog() + this->Painting.GetLog();
}

bool ExactShadows::Render(const MaskJob& job, MaskStage& masking, StageTimers& timers)
{
  const int lights = static_cast<int>(job.Frames.size());
  masking.Allocate(job.Samples, lights);
  if (job.Samples.GetSamplesAPixel() > 1)
  {
    masking.AllocateBits(job.Samples, lights);
  }
  this->Lengths.clear();
  this->Casting.StartFrame(lights);
  for (int light = 0; light < lights; ++light)
  {
    const LightFrame& frame = job.Frames[light];
    {
      StageTimers::Scope timer(timers, "sample lists");
      this->Grid.Fill({ job.Samples, job.Table, frame, light, job.SceneSize, this->SamplesAPixel });
    }
    if (this->KeepsLengths)
    {
      this->Lengths.push_back(this->Grid.ReadLengths());
    }
    {
      StageTimers::Scope timer(timers, "exact test");
      this->Casting.Cast(
        { job.Store, job.Table, frame, job.Viewed, light, job.SceneSize, job.Cull }, this->Grid);
    }
    StageTimers::Scope timer(timers, "mask");
    if (!this->Draw(job, masking, light))
    {
      return false;
    }
  }
  this->Casting.FinishFrame();
  return masking.BindTarget(0);
}

bool ExactShadows::Draw(const MaskJob& job, MaskStage& masking, int light)
{
  if (!masking.BindTarget(light))
  {
    return false;
  }
  this->Resolve(this->Resolving, job, light);
  if (job.Samples.GetSamplesAPixel() > 1)
  {
    if (!masking.BindBits(light))
    {
      return false;
    }
    this->Resolve(this->Separating, job, light);
  }
  // The next light's samples take the place of these.
  ShowWhatWasWritten();
  return true;
}

void ExactShadows::Resolve(const Program& program, const MaskJob& job, int light)
{
  program.Use();
  this->Grid.BindStates();
  SetPoints(program, job.Samples.GetOffsets());
  job.Samples.Bind(program);
  MaskStage::SetLookup(
    program, { job.Lights, 0, job.Layers, job.Table }, light, light + job.OtherLayers);
  this->Triangle.Draw();
}

bool ExactShadows::PaintLists(const MaskJob& job, int light, double rounding)
{
  if (!this->Painting.Build({ { GL_VERTEX_SHADER, { rtwScreenVS } },
        { GL_FRAGMENT_SHADER,
          { rtwWarpFocus, this->Shape.Warp.Function, rtwViewSampleAccess, rtwSampleDepth,
            rtwSampleGridAccess, rtwDebugColours, rtwExactListsFS } } }))
  {
    return false;
  }
  const LightFrame& frame = job.Frames[light];
  // The grid holds the last light's samples.
  this->Grid.Fill({ job.Samples, job.Table, frame, light, job.SceneSize, 1 });
  this->Painting.Use();
  job.Samples.Bind(this->Painting);
  job.Samples.BindDepth(this->Painting, -rounding);
  job.Table.Bind(this->Painting);
  this->Grid.Bind(this->Painting);
  BindLight(this->Painting, frame, job.Viewed, 1);
  this->Painting.Set("rtwLayer", light);
  this->Triangle.DrawOver();
  ShowWhatWasWritten();
  return true;
}

void ExactShadows::WhereIncomplete(const std::function<void()>& draw)
{
  this->Incomplete.Decide([this] {
    glViewport(0, 0, 1, 1);
    this->Failing.Use();
    this->Casting.BindQueue();
    this->Triangle.Draw();
  });
  this->Incomplete.Draw(draw);
}

bool ExactShadows::WasIncomplete()
{
  if (!this->Casting.HasOverflowed())
  {
    return false;
  }
  this->Casting.SetCapacity(2 * this->Casting.GetCapacity());
  return true;
}

void ExactShadows::SetMemoryBound(std::size_t bytes)
{
  this->Casting.SetCapacity(bytes / ItemBytes);
}

std::size_t ExactShadows::GetMemoryBound() const
{
  return this->Casting.GetCapacity() * ItemBytes;
}

std::uint64_t ExactShadows::GetSignature() const
{
  return Mix(Mix(std::uint64_t(1), std::uint64_t(this->SamplesAPixel)),
    std::uint64_t(this->Casting.GetCapacity()));
}

std::size_t ExactShadows::GetMemory() const
{
  return this->Grid.GetMemory() + this->Casting.GetMemory();
}

void ExactShadows::Dispose(Disposal dispose)
{
  dispose(this->Grid, this->Casting, this->Resolving, this->Separating, this->Failing,
    this->Painting, this->Incomplete, this->Triangle);
}
}
