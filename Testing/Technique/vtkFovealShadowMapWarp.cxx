// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFovealShadowMapWarp.h"

#include "rtwFovealWarpStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFovealShadowMapWarp);

vtkFovealShadowMapWarp::vtkFovealShadowMapWarp() = default;
vtkFovealShadowMapWarp::~vtkFovealShadowMapWarp() = default;

std::unique_ptr<rtw::WarpStage> vtkFovealShadowMapWarp::MakeStage()
{
  return std::make_unique<rtw::FovealWarpStage>();
}
