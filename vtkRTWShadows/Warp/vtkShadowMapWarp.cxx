// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapWarp.h"

#include "Warp/rtwWarpStage.h"

vtkShadowMapWarp::vtkShadowMapWarp() = default;
vtkShadowMapWarp::~vtkShadowMapWarp() = default;

void vtkShadowMapWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
