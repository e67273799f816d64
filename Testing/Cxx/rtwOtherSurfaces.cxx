// SPDX-License-Identifier: BSD-3-Clause
#include "rtwOtherSurfaces.h"

#include "vtkRenderWindow.h"

#include <cmath>
#include <memory>

int rtwCountOtherSurfaces(
  vtkRenderWindow* window, const std::vector<unsigned char>& mask, const rtw::Truth& truth)
{
  const std::unique_ptr<float[]> depths(
    window->GetZbufferData(0, 0, truth.Width - 1, truth.Height - 1));
  int others = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const bool isWrong = (truth.Mask[i] == rtw::MASK_LIT && mask[i] < rtw::MASK_AVERTED) ||
      (truth.Mask[i] == rtw::MASK_SHADOW && mask[i] > rtw::MASK_AVERTED);
    others += isWrong && std::abs(depths[i] - truth.Depth[i]) > 1e-6;
  }
  return others;
}
