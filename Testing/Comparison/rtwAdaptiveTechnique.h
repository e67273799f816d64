// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwAdaptiveTechnique_h
#define rtwAdaptiveTechnique_h

#include "rtwTechnique.h"

#include <vtkAdaptiveShadowMapPass.h>
#include <vtkNew.h>
#include <vtkShadowRenderStepsPass.h>
#include <vtkSmartPointer.h>

namespace rtw
{
/// One of this module's passes, around a whole frame.
class AdaptiveTechnique : public Technique
{
public:
  AdaptiveTechnique(vtkAdaptiveShadowMapPass* pass, const TechniqueSettings& settings);

  void Install(vtkRenderer* renderer) override;
  void SetRebuilding(bool rebuilding) override { this->Shadows->SetCaching(!rebuilding); }
  std::vector<unsigned char> MakeMask() override;
  TexelFunction GetTexels() override;
  bool SetDebugPicture(DebugPicture picture) override;
  double GetPredictedError() override { return this->Shadows->GetPredictedError(0); }
  int64_t GetMemory() override { return this->Shadows->GetShadowMemory(); }
  std::vector<Stage> GetStages() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  vtkSmartPointer<vtkAdaptiveShadowMapPass> Shadows;
  vtkNew<vtkShadowRenderStepsPass> Steps;
  vtkRenderer* Renderer = nullptr;
};
}

#endif
