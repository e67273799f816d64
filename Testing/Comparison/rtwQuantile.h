// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwQuantile_h
#define rtwQuantile_h

#include <utility>
#include <vector>

namespace rtw
{
/// The value that a share of all values lie below, between the nearest two; 0 if there are none.
double Quantile(std::vector<double> values, double share);

inline double Median(std::vector<double> values)
{
  return Quantile(std::move(values), 0.5);
}
}

#endif
