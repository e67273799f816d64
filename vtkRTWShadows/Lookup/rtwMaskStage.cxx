// SPDX-License-Identifier: BSD-3-Clause
#include "Lookup/rtwMaskStage.h"

#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwScreenVS.h"
#include "Layers/rtwDenseLayers.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwWarpFocus.h"
#include "Lookup/rtwGatherLayers.h"
#include "Lookup/rtwMaskFS.h"
#include "Lookup/rtwMaskValue.h"

namespace rtw
{
namespace
{
constexpr int DepthUnit = 1;
constexpr int GradientUnit = 2;
constexpr unsigned int LayersBinding = LayerTable::UniformBinding + 2;
constexpr std::size_t LayerBytes = 32; // as in rtwGatherLayers.glsl
}

bool MaskStage::Build(const ReceiverShape& shape, TableAccess access, bool layersInUniforms)
{
  ReceiverShape one = shape; // each light is drawn by itself
  one.Switched = { 0 };
  if (!(one == this->Shape) || this->Access != access || this->LayersInUniforms != layersInUniforms)
  {
    this->Drawing.Release();
    this->Shape = one;
    this->Access = access;
    this->LayersInUniforms = layersInUniforms;
  }
  const std::string definitions =
    DefinitionsOf(one) + (layersInUniforms ? "#define RTW_LAYERS_IN_UNIFORMS\n" : "");
  const std::string lookup = LookupCode(one);
  const bool gathers = !layersInUniforms ||
    this->Gathering.Build(
      { { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwLayerInterval, rtwGatherLayers } } });
  return gathers &&
    this->Drawing.Build(
      { { GL_VERTEX_SHADER, { rtwScreenVS } },
        { GL_FRAGMENT_SHADER,
          { LayerTable::DefinitionOf(access), definitions.c_str(), rtwWarpFocus, one.Warp.Function,
            lookup.c_str(), rtwViewSampleAccess, rtwMaskValue, rtwMaskFS } } },
      150);
}

void MaskStage::Allocate(const ViewSampler& samples, int lights)
{
  this->Mask.Allocate(Format::Byte1, samples.GetWidth(), samples.GetHeight(), lights);
}

bool MaskStage::BindTarget(int light)
{
  return this->Target.BindColour(this->Mask, light);
}

void MaskStage::AllocateBits(const ViewSampler& samples, int lights)
{
  this->Bits.Allocate(Format::Bits1, samples.GetWidth(), samples.GetHeight(), lights);
}

bool MaskStage::BindBits(int light)
{
  return this->BitsTarget.BindColour(this->Bits, light);
}

void MaskStage::ClearBits()
{
  constexpr GLuint none[] = { 0, 0, 0, 0 };
  for (int light = 0; light < this->Bits.GetLayers(); ++light)
  {
    if (this->BindBits(light))
    {
      glClearBufferuiv(GL_COLOR, 0, none);
    }
  }
}

void MaskStage::SetLookup(
  const Program& program, const MaskLookup& lookup, int light, int firstLayer)
{
  const ReceiverLights& lights = lookup.Lights;
  lookup.Table.Bind(program);
  lookup.Table.BindLayer(firstLayer);
  lookup.Layers.GetDepths().Bind(DepthUnit);
  lookup.Layers.GetGradients().Bind(GradientUnit);
  program.Set("rtwDepths", DepthUnit);
  program.Set("rtwGradients", GradientUnit);
  program.Set("rtwOtherLayers", lookup.OtherLayers);
  program.Set("rtwFilterJitter", lights.FilterJitter);
  glUniform4fv(program.Location("rtwSides"), 4, &lights.Sides[0].x);
  program.Set("rtwFirstLayer", firstLayer);
  program.SetMatrix("rtwToLight", lights.ToLight.data() + 16 * light);
  glUniform4fv(program.Location("rtwCone"), 1, lights.Cone.data() + 4 * light);
  glUniform4fv(program.Location("rtwTolerance"), 1, lights.Tolerance.data() + 4 * light);
  glUniform4fv(program.Location("rtwBeams"), 1, lights.Beams.data() + 4 * light);
  glUniform4fv(program.Location("rtwTaps"), 1, lights.Taps.data() + 4 * light);
}

void MaskStage::Render(const ReceiverLights& lights, int otherLayers, const ViewSampler& samples,
  const DenseLayers& layers, const LayerTable& table)
{
  this->Allocate(samples, lights.Count);
  if (this->LayersInUniforms)
  {
    this->GatherLayers(table, lights.Count * this->Shape.Parts);
  }
  this->Drawing.Use();
  this->Drawing.SetBlock("Layers", LayersBinding);
  samples.Bind(this->Drawing);
  for (int light = 0; light < lights.Count; ++light)
  {
    if (!this->BindTarget(light))
    {
      return;
    }
    SetLookup(this->Drawing, { lights, otherLayers, layers, table }, light, light * this->Shape.Parts);
    this->BindGathered(light);
    this->Triangle.Draw();
  }
}

void MaskStage::GatherLayers(const LayerTable& table, int layers)
{
  this->Gathered.Reserve(layers * LayerBytes);
  this->Gathering.Use();
  table.Bind(this->Gathering);
  this->Gathered.BindStorage(0);
  this->Gathering.Set("rtwNumberOfLayers", layers);
  Dispatch(Groups(layers, 32));
}

void MaskStage::BindGathered(int light) const
{
  if (this->LayersInUniforms)
  {
    const std::size_t bytes = this->Shape.Parts * LayerBytes;
    this->Gathered.BindUniforms(LayersBinding, light * bytes, bytes);
  }
}

void MaskStage::Dispose(Disposal dispose)
{
  dispose(this->Drawing, this->Gathering, this->Gathered, this->Mask, this->Bits, this->BitsTarget,
    this->Target, this->Triangle);
}
}
