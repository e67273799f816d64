// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMaskStage.h"

#include "rtwDenseLayers.h"
#include "rtwMaskFS.h"
#include "rtwMaskValue.h"
#include "rtwOpenGL.h"
#include "rtwScreenVS.h"
#include "rtwViewSampleAccess.h"
#include "rtwViewSampler.h"
#include "rtwWarpFocus.h"

namespace rtw
{
namespace
{
constexpr int DepthUnit = 1;
constexpr int GradientUnit = 2;
}

bool MaskStage::Build(const ReceiverShape& shape, TableAccess access)
{
  ReceiverShape one = shape; // each light is drawn by itself
  one.Switched = { 0 };
  if (!(one == this->Shape) || this->Access != access)
  {
    this->Drawing.Release();
    this->Shape = one;
    this->Access = access;
  }
  const std::string definitions = DefinitionsOf(one), lookup = LookupCode(one);
  return this->Drawing.Build(
    { { GL_VERTEX_SHADER, { rtwScreenVS } },
      { GL_FRAGMENT_SHADER,
        { WarpTable::DefinitionOf(access), definitions.c_str(), rtwWarpFocus, one.Warp.Function, lookup.c_str(), rtwViewSampleAccess,
          rtwMaskValue, rtwMaskFS } } },
    150);
}

void MaskStage::Render(const ReceiverLights& lights, int otherLayers, const ViewSampler& samples,
  const DenseLayers& layers, const WarpTable& table)
{
  this->Mask.Allocate(Format::Byte1, samples.GetWidth(), samples.GetHeight(), lights.Count);
  this->Drawing.Use();
  samples.Bind(this->Drawing);
  table.Bind(this->Drawing);
  layers.GetDepths().Bind(DepthUnit);
  layers.GetGradients().Bind(GradientUnit);
  this->Drawing.Set("rtwDepths", DepthUnit);
  this->Drawing.Set("rtwGradients", GradientUnit);
  this->Drawing.Set("rtwOtherLayers", otherLayers);
  this->Drawing.Set("rtwFilterJitter", lights.FilterJitter);
  for (int light = 0; light < lights.Count; ++light)
  {
    if (!this->Target.BindColour(this->Mask, light))
    {
      return;
    }
    this->Drawing.Set("rtwFirstLayer", light);
    table.BindLayer(light);
    this->Drawing.SetMatrix("rtwToLight", lights.ToLight.data() + 16 * light);
    glUniform4fv(this->Drawing.Location("rtwCone"), 1, lights.Cone.data() + 4 * light);
    glUniform4fv(this->Drawing.Location("rtwTolerance"), 1, lights.Tolerance.data() + 4 * light);
    glUniform4fv(this->Drawing.Location("rtwTaps"), 1, lights.Taps.data() + 4 * light);
    this->Triangle.Draw();
  }
  layers.GetDepths().Unbind(DepthUnit);
  layers.GetGradients().Unbind(GradientUnit);
}

void MaskStage::Release()
{
  this->Drawing.Release();
  this->Mask.Release();
  this->Target.Release();
  this->Triangle.Release();
}

void MaskStage::Abandon()
{
  this->Drawing.Abandon();
  this->Mask.Abandon();
  this->Target.Abandon();
  this->Triangle.Abandon();
}
}
