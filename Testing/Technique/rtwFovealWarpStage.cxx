// SPDX-License-Identifier: BSD-3-Clause
#include "rtwFovealWarpStage.h"

#include "rtwBendFoveal.h"
#include "rtwSlopeFoveal.h"
#include "rtwWarpFoveal.h"

#include <cmath>

namespace rtw
{
double FovealFunction::Forward(double onFocus)
{
  return 0.5 + std::asinh(Sharpness * (2 * onFocus - 1)) / (2 * std::asinh(Sharpness));
}

double FovealFunction::Inverse(double onMap)
{
  return 0.5 + std::sinh(std::asinh(Sharpness) * (2 * onMap - 1)) / (2 * Sharpness);
}

double FovealFunction::GreatestSlope()
{
  return Sharpness / std::asinh(Sharpness);
}

WarpShape FovealWarpStage::GetShape() const
{
  return { "foveal", rtwWarpFoveal, rtwBendFoveal, rtwSlopeFoveal };
}
}
