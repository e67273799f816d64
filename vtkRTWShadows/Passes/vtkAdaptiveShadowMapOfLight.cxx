// SPDX-License-Identifier: BSD-3-Clause
// What a vtkAdaptiveShadowMapPass says of a light, asked by the vtkLight instead of its number.
#include "vtkAdaptiveShadowMapPass.h"

#include "Passes/rtwAdaptiveShadowMapInternals.h"

int vtkAdaptiveShadowMapPass::GetShadowLightIndex(vtkLight* light)
{
  const int index = rtw::FindLight(this->Shadows->Lights, light);
  return this->Shadows->Has(index) ? index : -1;
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersDrawn(vtkLight* light)
{
  return this->GetNumberOfCastersDrawn(this->GetShadowLightIndex(light));
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersCulled(vtkLight* light)
{
  return this->GetNumberOfCastersCulled(this->GetShadowLightIndex(light));
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersDrawn(vtkLight* light, int layer)
{
  return this->GetNumberOfCastersDrawn(this->GetShadowLightIndex(light), layer);
}

int vtkAdaptiveShadowMapPass::GetNumberOfCastersCulled(vtkLight* light, int layer)
{
  return this->GetNumberOfCastersCulled(this->GetShadowLightIndex(light), layer);
}

int vtkAdaptiveShadowMapPass::GetNumberOfLightLayers(vtkLight* light)
{
  return this->GetNumberOfLightLayers(this->GetShadowLightIndex(light));
}

bool vtkAdaptiveShadowMapPass::GetLayerDepthRange(vtkLight* light, int layer, double range[2])
{
  return this->GetLayerDepthRange(this->GetShadowLightIndex(light), layer, range);
}

double vtkAdaptiveShadowMapPass::GetMaximumEffectiveResolution(vtkLight* light, int axis)
{
  return this->GetMaximumEffectiveResolution(this->GetShadowLightIndex(light), axis);
}

vtkImageData* vtkAdaptiveShadowMapPass::GetShadowMask(vtkLight* light)
{
  return this->GetShadowMask(this->GetShadowLightIndex(light));
}

vtkImageData* vtkAdaptiveShadowMapPass::GetShadowMapImage(vtkLight* light, int layer)
{
  return this->GetShadowMapImage(this->GetShadowLightIndex(light), layer);
}

vtkImageData* vtkAdaptiveShadowMapPass::GetWarpImage(vtkLight* light, int layer)
{
  return this->GetWarpImage(this->GetShadowLightIndex(light), layer);
}

vtkImageData* vtkAdaptiveShadowMapPass::GetImportanceImage(vtkLight* light, int layer)
{
  return this->GetImportanceImage(this->GetShadowLightIndex(light), layer);
}

vtkImageData* vtkAdaptiveShadowMapPass::GetAliasingErrorImage(vtkLight* light)
{
  return this->GetAliasingErrorImage(this->GetShadowLightIndex(light));
}

double vtkAdaptiveShadowMapPass::GetPredictedError(vtkLight* light)
{
  return this->GetPredictedError(this->GetShadowLightIndex(light));
}

bool vtkAdaptiveShadowMapPass::GetLightPlaneMatrix(
  vtkLight* light, int layer, vtkMatrix4x4* worldToPlane)
{
  return this->GetLightPlaneMatrix(this->GetShadowLightIndex(light), layer, worldToPlane);
}
