// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInspectableShadowMapPass.h"

#include "vtkLight.h"

vtkInspectableShadowMapPass::vtkInspectableShadowMapPass() = default;
vtkInspectableShadowMapPass::~vtkInspectableShadowMapPass() = default;

void vtkInspectableShadowMapPass::SetDebugView(int view)
{
  if (view < NONE || view > LIST_LENGTHS)
  {
    vtkErrorMacro("SetDebugView("
      << view
      << "): expected NONE (0), SHADOW (1), ALIASING_ERROR (2), IMPORTANCE (3), WARP_GRID (4), "
         "LAYERS (5) or LIST_LENGTHS (6); keeping "
      << this->DebugView);
    return;
  }
  if (this->DebugView != view)
  {
    this->DebugView = view;
    this->Modified();
  }
}

void vtkInspectableShadowMapPass::SetDebugLight(int light)
{
  if (light < 0)
  {
    vtkErrorMacro("SetDebugLight("
      << light << "): expected a light's number among those with shadows, from 0 on; keeping "
      << this->DebugLight);
    return;
  }
  if (this->DebugLight != light || this->NamedDebugLight)
  {
    this->DebugLight = light;
    this->NamedDebugLight = nullptr;
    this->Modified();
  }
}

void vtkInspectableShadowMapPass::SetDebugLight(vtkLight* light)
{
  if (!light)
  {
    vtkErrorMacro("SetDebugLight(null): expected a vtkLight, or a light's number among those with "
                  "shadows; keeping "
      << this->DebugLight);
    return;
  }
  if (this->NamedDebugLight != light)
  {
    this->NamedDebugLight = light;
    this->Modified();
  }
}

void vtkInspectableShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DebugView: " << this->DebugView << "\n";
  os << indent << "DebugLight: " << this->DebugLight << "\n";
  os << indent << "NamedDebugLight: " << this->NamedDebugLight.Get() << "\n";
}
