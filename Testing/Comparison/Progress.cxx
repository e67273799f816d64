// SPDX-License-Identifier: BSD-3-Clause
#include "rtwProgress.h"

#include <cstdio>

namespace rtw
{
Progress::Progress(std::string task)
  : Task(std::move(task))
  , Next(Clock::now() + std::chrono::seconds(2))
{
}

void Progress::Tell(double share)
{
  if (Clock::now() >= this->Next && share < 1)
  {
    std::fprintf(stderr, "%s: %.0f %%\n", this->Task.c_str(), 100 * share);
    this->Next = Clock::now() + std::chrono::seconds(2);
  }
}
}
