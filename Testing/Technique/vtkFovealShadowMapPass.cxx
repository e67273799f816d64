// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFovealShadowMapPass.h"

#include "vtkFovealShadowMapWarp.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFovealShadowMapPass);

vtkFovealShadowMapPass::vtkFovealShadowMapPass()
{
  vtkNew<vtkFovealShadowMapWarp> warp;
  this->SetWarp(warp);
}

vtkFovealShadowMapPass::~vtkFovealShadowMapPass() = default;
