// SPDX-License-Identifier: BSD-3-Clause
#include "rtwFlicker.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace rtw
{
void Flicker::Add(const std::vector<unsigned char>& mask, const Truth& truth)
{
  if (mask.size() != truth.Mask.size())
  {
    throw std::invalid_argument("the mask has " + std::to_string(mask.size()) +
      " pixels, but the truth has " + std::to_string(truth.Mask.size()));
  }
  if (mask.size() == this->LastMask.size() && truth.Width == this->LastWidth)
  {
    size_t steady = 0, changed = 0;
    for (size_t i = 0; i < mask.size(); ++i)
    {
      const unsigned char stays = truth.Mask[i];
      if (stays == this->LastTruth[i] && (stays == MASK_LIT || stays == MASK_SHADOW))
      {
        const unsigned char before = this->LastMask[i], now = mask[i];
        ++steady;
        changed += (before < MASK_AVERTED && now > MASK_AVERTED) ||
          (before > MASK_AVERTED && now < MASK_AVERTED);
      }
    }
    this->Steps.push_back(steady ? 100.0 * double(changed) / double(steady) : 0.0);
  }
  this->LastMask = mask;
  this->LastTruth = truth.Mask;
  this->LastWidth = truth.Width;
}

double Flicker::MeanPercent() const
{
  return this->Steps.empty()
    ? 0.0
    : std::accumulate(this->Steps.begin(), this->Steps.end(), 0.0) / double(this->Steps.size());
}

double Flicker::GreatestPercent() const
{
  return this->Steps.empty() ? 0.0 : *std::max_element(this->Steps.begin(), this->Steps.end());
}
}
