// SPDX-License-Identifier: BSD-3-Clause
#include "Techniques.h"

#include "rtwCompare.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRTWShadowMapPass.h>
#include <vtkShadowRenderStepsPass.h>
#include <vtkUniformShadowMapPass.h>

namespace
{
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

void Configure(vtkAdaptiveShadowMapPass* pass, int resolution, const Options& options)
{
  pass->SetResolution(unsigned(resolution));
  pass->SetTimeStages(options.Stages);
  if (options.Filtering)
  {
    pass->SetFilter(*options.Filtering == Filter::NEAREST ? vtkAdaptiveShadowMapPass::NEAREST
                                                          : vtkAdaptiveShadowMapPass::BILINEAR);
  }
  if (options.Test)
  {
    pass->SetDepthTest(ToDepthTest(*options.Test));
  }
  if (options.Focus)
  {
    pass->SetFocusOnView(*options.Focus);
  }
}

// One of this module's passes, around a whole frame.
class AdaptiveTechnique : public Technique
{
public:
  AdaptiveTechnique(vtkAdaptiveShadowMapPass* pass, int resolution, const Options& options)
    : Shadows(pass)
  {
    Configure(pass, resolution, options);
    this->Steps->SetShadowMapPass(pass);
  }

  void Install(vtkRenderer* renderer) override
  {
    this->Renderer = renderer;
    renderer->SetPass(this->Steps);
  }

  void SetRebuilding(bool rebuilding) override { this->Shadows->SetCaching(!rebuilding); }

  std::vector<unsigned char> MakeMask() override
  {
    if (vtkImageData* mask = this->Shadows->GetShadowMask(0))
    {
      return rtw::MaskOf(mask);
    }
    // It makes no shadows of such a light.
    const int* size = this->Renderer->GetSize();
    return std::vector<unsigned char>(size_t(size[0]) * size[1], rtw::MASK_LIT);
  }

  int64_t GetMemory() override { return this->Shadows->GetShadowMemory(); }

  std::vector<Stage> GetStages() override
  {
    std::vector<Stage> stages;
    for (int i = 0; i < this->Shadows->GetNumberOfStages(); ++i)
    {
      stages.push_back({ this->Shadows->GetStageName(i), this->Shadows->GetStageMilliseconds(i) });
    }
    return stages;
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Steps->ReleaseGraphicsResources(window);
  }

private:
  vtkSmartPointer<vtkAdaptiveShadowMapPass> Shadows;
  vtkNew<vtkShadowRenderStepsPass> Steps;
  vtkRenderer* Renderer = nullptr;
};
}

std::unique_ptr<Technique> MakeUniformTechnique(int resolution, const Options& options)
{
  vtkNew<vtkUniformShadowMapPass> pass;
  return std::make_unique<AdaptiveTechnique>(pass, resolution, options);
}

std::unique_ptr<Technique> MakeRTWTechnique(int resolution, const Options& options)
{
  vtkNew<vtkRTWShadowMapPass> pass;
  if (options.ImportanceKind)
  {
    pass->SetImportance(*options.ImportanceKind == Importance::SQRT_DEMAND
        ? vtkRTWShadowMapPass::SQRT_DEMAND
        : vtkRTWShadowMapPass::DESIRED_VIEW | vtkRTWShadowMapPass::DISTANCE_TO_EYE |
          vtkRTWShadowMapPass::SURFACE_NORMAL);
  }
  return std::make_unique<AdaptiveTechnique>(pass, resolution, options);
}
