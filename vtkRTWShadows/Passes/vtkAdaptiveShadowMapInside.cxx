// SPDX-License-Identifier: BSD-3-Clause
// How one looks inside a vtkAdaptiveShadowMapPass.
#include "vtkAdaptiveShadowMapPass.h"

#include "Passes/rtwAdaptiveShadowMapInternals.h"

#include "vtkLight.h"

#include <algorithm>
#include <string>

int vtkAdaptiveShadowMapPass::ChooseDebugLight()
{
  Internals& my = *this->Shadows;
  const int last = this->GetNumberOfShadowLights() - 1;
  if (this->NamedDebugLight)
  {
    const int named = this->GetShadowLightIndex(this->NamedDebugLight);
    if (named < 0 && my.WarnedOfNamedLight != this->NamedDebugLight)
    {
      vtkWarningMacro("the vtkLight of SetDebugLight() casts no shadow in this renderer; viewing "
        << std::min(this->DebugLight, last));
    }
    my.WarnedOfNamedLight = named < 0 ? this->NamedDebugLight.Get() : nullptr;
    // Not a change of settings, for which a frame would be drawn anew.
    this->DebugLight = named < 0 ? std::min(this->DebugLight, last) : named;
  }
  if (this->DebugLight > last && my.WarnedOfDebugLight != this->DebugLight)
  {
    my.WarnedOfDebugLight = this->DebugLight;
    vtkWarningMacro("DebugLight " << this->DebugLight
                                  << " is more than the last light with shadows; viewing " << last);
  }
  return std::min(this->DebugLight, last);
}

void vtkAdaptiveShadowMapPass::PaintDebugView(vtkRenderer* renderer)
{
  Internals& my = *this->Shadows;
  const bool painted = my.Pipeline.PaintDebugView(static_cast<rtw::DebugView>(this->DebugView),
    this->ChooseDebugLight(), my.Options,
    [this, renderer] { this->DrawViewSamples(renderer); });
  if (!painted && !my.WarnedOfDebugShader)
  {
    my.WarnedOfDebugShader = true;
    const std::string log = my.Pipeline.GetDebugLog();
    vtkWarningMacro("draws no DebugView, because "
      << (log.empty() ? "there are no lists of view samples" : "the driver refused a shader: ")
      << log);
  }
}

vtkImageData* vtkAdaptiveShadowMapPass::GetImportanceImage(int light, int layer)
{
  Internals& my = *this->Shadows;
  const int index = my.LayerOf(light, layer);
  my.ImportanceImage = index >= 0 && my.MakeCurrent()
    ? rtw::MakeImportanceImage(
        my.Pipeline.ReadImportance(index), my.Pipeline.GetShape().Kind == rtw::WarpKind::Grid)
    : nullptr;
  return my.ImportanceImage;
}

vtkImageData* vtkAdaptiveShadowMapPass::GetAliasingErrorImage(int light)
{
  Internals& my = *this->Shadows;
  my.AliasingImage = nullptr;
  if (my.Has(light) && my.Renderer && my.MakeCurrent())
  {
    vtkRenderer* renderer = my.Renderer;
    rtw::Texture error;
    if (my.Pipeline.MeasureAliasing(
          light, error, [this, renderer] { this->DrawViewSamples(renderer); }))
    {
      my.AliasingImage = rtw::ReadAliasing(error);
    }
    error.Release();
  }
  return my.AliasingImage;
}

double vtkAdaptiveShadowMapPass::GetPredictedError(int light)
{
  Internals& my = *this->Shadows;
  if (!my.Has(light) || !my.Renderer || !my.MakeCurrent())
  {
    return -1;
  }
  vtkRenderer* renderer = my.Renderer;
  return my.Pipeline.PredictError(
    light, my.Options, [this, renderer] { this->DrawViewSamples(renderer); });
}
