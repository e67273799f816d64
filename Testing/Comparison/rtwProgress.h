// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwProgress_h
#define rtwProgress_h

#include <chrono>
#include <string>

namespace rtw
{
/// Tells on stderr how far a long task is; of a short one, nothing.
class Progress
{
public:
  explicit Progress(std::string task);
  void Tell(double share);

private:
  using Clock = std::chrono::steady_clock;

  std::string Task;
  Clock::time_point Next;
};
}

#endif
