// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Identity/rtwIdentityWarpStage.h"

#include "Warp/Identity/rtwBendIdentity.h"
#include "Warp/Identity/rtwSlopeIdentity.h"
#include "Warp/Identity/rtwWarpIdentity.h"

namespace rtw
{
WarpShape IdentityWarpStage::GetShape() const
{
  return { "identity", rtwWarpIdentity, rtwBendIdentity, rtwSlopeIdentity };
}
}
