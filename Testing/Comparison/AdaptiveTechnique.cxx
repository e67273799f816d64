// SPDX-License-Identifier: BSD-3-Clause
#include "rtwAdaptiveTechnique.h"

#include "rtwCompare.h"
#include "rtwMapTexels.h"

#include <vtkCamera.h>
#include <vtkCascadedShadowMapPass.h>
#include <vtkImageData.h>
#include <vtkRenderer.h>

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace rtw
{
AdaptiveTechnique::AdaptiveTechnique(
  vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings)
  : Shadows(pass)
{
  settings.Apply(pass);
  this->Steps->SetShadowMapPass(pass);
}

void AdaptiveTechnique::Install(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  renderer->SetPass(this->Steps);
}

std::vector<unsigned char> AdaptiveTechnique::MakeMask()
{
  if (vtkImageData* mask = this->Shadows->GetShadowMask(0))
  {
    return MaskOf(mask);
  }
  // It makes no shadows of such a light.
  const int* size = this->Renderer->GetSize();
  return std::vector<unsigned char>(size_t(size[0]) * size[1], MASK_LIT);
}

TexelFunction AdaptiveTechnique::GetTexels()
{
  const int layers = this->Shadows->GetNumberOfLightLayers(0);
  auto* cascades = vtkCascadedShadowMapPass::SafeDownCast(this->Shadows);
  if (cascades && cascades->GetSplitFaces())
  {
    return {}; // depths alone don't tell the layer
  }
  if (layers <= 1)
  {
    return TexelsOf(this->Shadows, 0);
  }
  std::vector<TexelFunction> functions;
  std::vector<double> begins;
  for (int layer = 0; layer < layers; ++layer)
  {
    double range[2];
    this->Shadows->GetLayerDepthRange(0, layer, range);
    begins.push_back(range[0]);
    functions.push_back(TexelsOf(this->Shadows, 0, layer));
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 eye = glm::make_vec3(camera->GetPosition());
  const glm::dvec3 forward = glm::make_vec3(camera->GetDirectionOfProjection());
  return [=](const glm::dvec3& world) {
    const double depth = glm::dot(world - eye, forward);
    int layer = layers - 1;
    while (layer > 0 && depth < begins[layer])
    {
      --layer;
    }
    return functions[layer](world);
  };
}

static_assert(
  static_cast<int>(DebugPicture::LIST_LENGTHS) == vtkAdaptiveShadowMapPass::LIST_LENGTHS,
  "one order");

bool AdaptiveTechnique::SetDebugPicture(DebugPicture picture)
{
  this->Shadows->SetDebugView(static_cast<int>(picture));
  return true;
}

std::vector<Stage> AdaptiveTechnique::GetStages()
{
  std::vector<Stage> stages;
  for (int i = 0; i < this->Shadows->GetNumberOfStages(); ++i)
  {
    stages.push_back({ this->Shadows->GetStageName(i), this->Shadows->GetStageMilliseconds(i) });
  }
  return stages;
}

void AdaptiveTechnique::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Steps->ReleaseGraphicsResources(window);
}

std::unique_ptr<Technique> MakeAdaptiveTechnique(
  vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings)
{
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}
}
