// SPDX-License-Identifier: BSD-3-Clause
// How a frame's mask comes from elsewhere than the maps.
#include "Passes/rtwShadowPipeline.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwStateGuard.h"
#include "Storage/Exact/rtwSampleGrid.h"

#include <algorithm>

namespace rtw
{
bool ShadowPipeline::UsesSource(const PipelineOptions& options) const
{
  return this->Source && this->OwnDrawing && options.Masked && this->HasSamples;
}

int ShadowPipeline::CountMaskSamples() const
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  const int most = std::min(this->Can.MaximumSamples, SampleGrid::MostSamplesAPixel);
  const bool can = this->Source && this->OwnDrawing && this->SourceProblem.empty();
  return can && samples <= most ? std::max(samples, 1) : 0;
}

MaskJob ShadowPipeline::MakeJob(const ReceiverLights& lights, const PipelineOptions& options) const
{
  return { this->Frames, this->Viewed, this->Sampler, this->Store, this->Table, this->Layers,
    lights, options.Shape, this->HasUniformTable() ? TableAccess::Uniforms : TableAccess::Storage,
    this->OtherLayers, this->SceneSize, options.Casters.Cull };
}

// False where the driver can't.
bool ShadowPipeline::DrawMaskBySource(StateGuard& guard, const FrameScene& scene,
  const PipelineOptions& options, const MapperDrawing& mappers)
{
  const ReceiverLights lights =
    ReceiverLights::Make(this->Frames, this->Viewed, options.Lookup, this->SceneSize);
  const MaskJob job = this->MakeJob(lights, options);
  const bool built = this->Source->Build(job);
  this->SourceProblem = built ? std::string() : this->Source->GetLog();
  this->HasMask = this->MaskedBySource =
    built && this->Source->Render(job, this->Masking, this->Timers);
  this->Masked = this->Viewed;
  if (this->HasMask)
  {
    this->Source->WhereIncomplete([&] {
      if (!this->HasMaps)
      {
        this->DrawLayers(guard, scene, options, mappers, true);
      }
      this->DrawMask(options);
      this->Masking.ClearBits();
      this->MaskedBySource = true;
    });
  }
  return this->HasMask;
}
}
