// SPDX-License-Identifier: BSD-3-Clause
#include "rtwAdaptiveTechnique.h"

#include "rtwCompare.h"
#include "rtwMapTexels.h"

#include <vtkCamera.h>
#include <vtkCascadedShadowMapPass.h>
#include <vtkExactShadowMapPass.h>
#include <vtkIdentityShadowMapWarp.h>
#include <vtkImageData.h>
#include <vtkNonOrthogonalShadowMapWarp.h>
#include <vtkNoTWShadowMapPass.h>
#include <vtkPerspectiveShadowMapPass.h>
#include <vtkPerspectiveShadowMapWarp.h>
#include <vtkRectilinearShadowMapWarp.h>
#include <vtkRenderer.h>
#include <vtkRTWShadowMapPass.h>
#include <vtkUniformShadowMapPass.h>

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace rtw
{
namespace
{
int ToFilter(Filter filter)
{
  switch (filter)
  {
    case Filter::NEAREST:
      return vtkAdaptiveShadowMapPass::NEAREST;
    case Filter::PCF:
      return vtkAdaptiveShadowMapPass::PCF;
    case Filter::SOFT:
      return vtkAdaptiveShadowMapPass::SOFT;
    default:
      return vtkAdaptiveShadowMapPass::BILINEAR;
  }
}

int ToDepthTest(DepthTest test)
{
  switch (test)
  {
    case DepthTest::RECEIVER_PLANE:
      return vtkAdaptiveShadowMapPass::RECEIVER_PLANE;
    case DepthTest::CONSTANT_BIAS:
      return vtkAdaptiveShadowMapPass::CONSTANT_BIAS;
    default:
      return vtkAdaptiveShadowMapPass::DUAL;
  }
}

static_assert(
  1 << static_cast<int>(Importance::SAMPLE_COUNT) == vtkRTWShadowMapPass::SAMPLE_COUNT &&
    1 << static_cast<int>(Importance::SQRT_DEMAND) == vtkRTWShadowMapPass::SQRT_DEMAND &&
    static_cast<int>(Analysis::HYBRID) == vtkRTWShadowMapPass::HYBRID &&
    static_cast<int>(Rasterization::AUTOMATIC) == vtkRTWShadowMapPass::AUTOMATIC &&
    static_cast<int>(LightPlaneTurn::MINIMAL_FRUSTUM) ==
      vtkRTWShadowMapPass::TURN_MINIMAL_FRUSTUM &&
    static_cast<int>(Perspective::UNWARPED) == vtkPerspectiveShadowMapPass::UNWARPED &&
    static_cast<int>(ResolutionSplit::AUTOMATIC) == vtkPerspectiveShadowMapPass::SPLIT_AUTOMATIC &&
    static_cast<int>(Splits::SAMPLE_DISTRIBUTION) ==
      vtkCascadedShadowMapPass::SAMPLE_DISTRIBUTION &&
    static_cast<int>(SampleSource::PREVIOUS_FRAME) == vtkRTWShadowMapPass::PREVIOUS_FRAME &&
    static_cast<int>(DebugPicture::LIST_LENGTHS) == vtkRTWShadowMapPass::LIST_LENGTHS,
  "one order");

void ConfigureDrawing(vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings)
{
  if (settings.Rasterizing)
  {
    pass->SetRasterization(static_cast<int>(*settings.Rasterizing));
  }
  if (settings.EdgeLength)
  {
    pass->SetMaximumEdgeLength(*settings.EdgeLength);
  }
  if (settings.Turn)
  {
    pass->SetLightPlaneTurn(static_cast<int>(*settings.Turn));
  }
  if (settings.CullCasters)
  {
    pass->SetCullCasters(*settings.CullCasters);
  }
  if (settings.SampleStride)
  {
    pass->SetViewSampleStride(*settings.SampleStride);
  }
  if (settings.Samples)
  {
    pass->SetViewSampleSource(static_cast<int>(*settings.Samples));
  }
}

void Configure(vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings)
{
  ConfigureDrawing(pass, settings);
  pass->SetResolution(unsigned(settings.Resolution));
  pass->SetTimeStages(settings.Stages);
  if (settings.Filtering)
  {
    pass->SetFilter(ToFilter(*settings.Filtering));
  }
  if (settings.FilterRadius)
  {
    pass->SetFilterRadius(*settings.FilterRadius);
  }
  if (settings.FilterJitter)
  {
    pass->SetFilterJitter(*settings.FilterJitter);
  }
  if (settings.Test)
  {
    pass->SetDepthTest(ToDepthTest(*settings.Test));
  }
  if (settings.Focus)
  {
    pass->SetFocusOnView(*settings.Focus);
  }
}
}

AdaptiveTechnique::AdaptiveTechnique(
  vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings)
  : Shadows(pass)
{
  Configure(pass, settings);
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

std::unique_ptr<Technique> MakeUniformTechnique(const TechniqueSettings& settings)
{
  vtkNew<vtkUniformShadowMapPass> pass;
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}

std::unique_ptr<Technique> MakeRTWTechnique(const TechniqueSettings& settings)
{
  vtkNew<vtkRTWShadowMapPass> pass;
  ConfigureImportance(pass->GetRectilinearWarp(), settings);
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}

namespace
{
void SetLayerWarp(vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings)
{
  if (settings.Warping == LayerWarp::PERSPECTIVE)
  {
    vtkNew<vtkPerspectiveShadowMapWarp> warp;
    ConfigurePerspective(warp, settings);
    pass->SetWarp(warp);
  }
  else if (settings.Warping == LayerWarp::RTW)
  {
    vtkNew<vtkRectilinearShadowMapWarp> warp;
    ConfigureImportance(warp, settings);
    pass->SetWarp(warp);
  }
  else if (settings.Warping == LayerWarp::NOTW)
  {
    vtkNew<vtkNonOrthogonalShadowMapWarp> warp;
    ConfigureNoTW(warp, settings);
    pass->SetWarp(warp);
  }
}
}

std::unique_ptr<Technique> MakeCascadesTechnique(const TechniqueSettings& settings)
{
  vtkNew<vtkCascadedShadowMapPass> pass;
  SetLayerWarp(pass, settings);
  if (settings.Layers)
  {
    pass->SetNumberOfLayers(*settings.Layers);
  }
  if (settings.Splitting)
  {
    pass->SetSplitScheme(static_cast<int>(*settings.Splitting));
  }
  if (settings.Lambda)
  {
    pass->SetLambda(*settings.Lambda);
  }
  if (settings.BlendWidth)
  {
    pass->SetBlendWidth(*settings.BlendWidth);
  }
  if (settings.SplitFaces)
  {
    pass->SetSplitFaces(*settings.SplitFaces);
  }
  if (settings.Stable)
  {
    pass->SetStable(*settings.Stable);
  }
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}

std::unique_ptr<Technique> MakePerspectiveTechnique(const TechniqueSettings& settings)
{
  vtkNew<vtkPerspectiveShadowMapPass> pass;
  ConfigurePerspective(pass->GetPerspectiveWarp(), settings);
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}

std::unique_ptr<Technique> MakeExactTechnique(const TechniqueSettings& settings)
{
  vtkNew<vtkExactShadowMapPass> pass;
  if (settings.Grid == GridWarp::IDENTITY)
  {
    pass->SetWarp(vtkNew<vtkIdentityShadowMapWarp>());
  }
  if (settings.Grid == GridWarp::NON_ORTHOGONAL)
  {
    pass->SetWarp(vtkNew<vtkNonOrthogonalShadowMapWarp>());
  }
  ConfigureImportance(pass->GetRectilinearWarp(), settings);
  if (settings.PixelSamples)
  {
    pass->SetSamplesPerPixel(*settings.PixelSamples);
  }
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}

std::unique_ptr<Technique> MakeNoTWTechnique(const TechniqueSettings& settings)
{
  vtkNew<vtkNoTWShadowMapPass> pass;
  ConfigureNoTW(pass->GetNonOrthogonalWarp(), settings);
  return std::make_unique<AdaptiveTechnique>(pass, settings);
}
}
