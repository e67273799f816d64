// SPDX-License-Identifier: BSD-3-Clause
#include "rtwQuantile.h"

#include <algorithm>
#include <cstddef>

namespace rtw
{
double Quantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0;
  }
  std::sort(values.begin(), values.end());
  const double at = std::clamp(share, 0.0, 1.0) * double(values.size() - 1);
  const auto low = std::size_t(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - double(low)) * (values[high] - values[low]);
}
}
