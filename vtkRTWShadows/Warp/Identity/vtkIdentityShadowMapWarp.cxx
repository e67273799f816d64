// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIdentityShadowMapWarp.h"

#include "Warp/Identity/rtwIdentityWarpStage.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkIdentityShadowMapWarp);

vtkIdentityShadowMapWarp::vtkIdentityShadowMapWarp() = default;
vtkIdentityShadowMapWarp::~vtkIdentityShadowMapWarp() = default;

std::unique_ptr<rtw::WarpStage> vtkIdentityShadowMapWarp::MakeStage()
{
  return std::make_unique<rtw::IdentityWarpStage>();
}
