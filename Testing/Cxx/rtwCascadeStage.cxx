// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCascadeStage.h"

#include "vtkCamera.h"
#include "vtkCascadedShadowMapPass.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <iostream>

rtwCascadeStage::rtwCascadeStage(const char* name)
  : rtwShadowStage(rtwTechnique::Cascades)
{
  this->Name = name;
  for (int i = 0; i < 6; ++i)
  {
    this->AddBox(2.0 * (i % 3) - 2.0, 0.5, 1.5 * (i / 3), 1.0);
    this->AddBox(20.0 * (i % 3) - 20.0, 3.0, -60.0 - 20.0 * (i / 3), 6.0);
  }
  this->AddFloor(200);
  this->Sun = this->AddSun(3, 4, 2);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0, 3, 8);
  camera->SetFocalPoint(0, 1.5, 0);
  this->Renderer->ResetCameraClippingRange();
  this->Pass->SetResolution(512);
}

vtkCascadedShadowMapPass* rtwCascadeStage::GetPass()
{
  return vtkCascadedShadowMapPass::SafeDownCast(this->Pass);
}

double rtwCascadeStage::Measure()
{
  this->Render();
  const rtw::ShadowErrors errors = rtw::Compare(this->GetMask(0), this->Trace(this->Sun));
  std::cout << this->Name << ": " << errors.Percent(errors.Wrong()) << " % wrong" << std::endl;
  return errors.Percent(errors.Wrong());
}

glm::dvec2 rtwCascadeStage::FindDepths()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 eye = glm::make_vec3(camera->GetPosition());
  const glm::dvec3 forward = glm::make_vec3(camera->GetDirectionOfProjection());
  const int* size = this->Window->GetSize();
  glm::dvec2 range(1e30, 0);
  this->Depths.assign(std::size_t(size[0]) * size[1], 0.0);
  for (const rtw::ViewSample& sample :
    rtw::ShadowReference(this->Renderer).Samples(this->Sun, size[0], size[1]))
  {
    const double depth = glm::dot(sample.Position - eye, forward);
    this->Depths[sample.Pixel] = depth;
    range = { std::min(range.x, depth), std::max(range.y, depth) };
  }
  return range;
}

glm::dvec2 rtwCascadeStage::GetRange(int light, int layer)
{
  double range[2] = { -1, -1 };
  RTW_CHECK(this->Pass->GetLayerDepthRange(light, layer, range));
  return { range[0], range[1] };
}
