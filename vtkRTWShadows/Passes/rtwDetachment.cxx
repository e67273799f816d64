// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/rtwDetachment.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

namespace rtw
{
Detachment::Detachment(const std::vector<vtkProp*>& props)
{
  vtkInformationObjectBaseVectorKey* const key = vtkOpenGLRenderPass::RenderPasses();
  for (vtkProp* prop : props)
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    const int passes = keys ? keys->Length(key) : 0;
    for (int i = 0; i < passes; ++i)
    {
      this->Detached.emplace_back(keys, keys->Get(key, i));
    }
    if (passes > 0)
    {
      keys->Remove(key);
    }
  }
}

Detachment::~Detachment()
{
  for (const auto& [keys, pass] : this->Detached)
  {
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
  }
}
}
