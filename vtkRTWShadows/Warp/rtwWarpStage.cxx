// SPDX-License-Identifier: BSD-3-Clause
#include "rtwWarpStage.h"

#include "rtwBendIdentity.h"
#include "rtwSlopeIdentity.h"
#include "rtwWarpIdentity.h"

namespace rtw
{
WarpShape IdentityWarpStage::GetShape() const
{
  return { "identity", rtwWarpIdentity, rtwBendIdentity, rtwSlopeIdentity };
}
}
