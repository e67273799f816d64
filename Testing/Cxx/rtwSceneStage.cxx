// SPDX-License-Identifier: BSD-3-Clause
#include "rtwSceneStage.h"

#include "rtwMapTexels.h"

#include "vtkAdaptiveShadowMapPass.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkShadowRenderStepsPass.h"

rtwSceneStage::rtwSceneStage(const std::string& scene, bool sharp)
  : rtwSceneStage(rtw::MakeScene(scene), sharp)
{
}

rtwSceneStage::rtwSceneStage(const rtw::Scene& scene, bool sharp)
  : Name(scene.Name)
{
  this->Window->SetSize(1024, 1024);
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  rtw::AddToRenderer(scene, this->Renderer);
  this->Light = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
  rtw::ReferenceOptions options;
  options.Sharp = sharp;
  this->Reference = std::make_unique<rtw::ShadowReference>(this->Renderer, options);
  this->Truth = this->Reference->Trace(this->Light, 1024, 1024);
}

rtw::ShadowErrors rtwSceneStage::Measure(vtkAdaptiveShadowMapPass* pass, int frames,
  double* predicted, rtw::TexelFunction* texels, std::vector<unsigned char>* mask)
{
  vtkNew<vtkShadowRenderStepsPass> steps;
  steps->SetShadowMapPass(pass);
  this->Renderer->SetPass(steps);
  const bool caching = pass->GetCaching();
  pass->SetCaching(caching && frames == 1);
  for (int frame = 0; frame < frames; ++frame)
  {
    this->Window->Render();
  }
  const std::vector<unsigned char> own = rtw::MaskOf(pass->GetShadowMask(0));
  const rtw::ShadowErrors errors = rtw::Compare(own, this->Truth);
  if (mask)
  {
    *mask = own;
  }
  if (predicted)
  {
    *predicted = pass->GetPredictedError(0);
  }
  if (texels)
  {
    *texels = rtw::TexelsOf(pass, 0);
  }
  pass->SetCaching(caching);
  steps->ReleaseGraphicsResources(this->Window);
  this->Renderer->SetPass(nullptr);
  return errors;
}
