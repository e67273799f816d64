// SPDX-License-Identifier: BSD-3-Clause
#ifndef Budget_h
#define Budget_h

#include <algorithm>
#include <chrono>

/// Shares a time out among tasks. What one leaves, those after it get.
class Budget
{
public:
  Budget(double minutes, int tasks)
    : End(Clock::now() +
        std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double, std::ratio<60>>(minutes)))
    , Tasks(tasks)
  {
  }

  void StartTask()
  {
    const auto left = std::max(this->End - Clock::now(), Clock::duration::zero());
    this->TaskStart = Clock::now();
    this->TaskEnd = this->TaskStart + left / std::max(this->Tasks--, 1);
  }

  /// Of the present task, in milliseconds; below zero if it takes longer than it may.
  double Left() const { return Milliseconds(this->TaskEnd - Clock::now()); }
  double Whole() const { return Milliseconds(this->TaskEnd - this->TaskStart); }

private:
  using Clock = std::chrono::steady_clock;

  static double Milliseconds(Clock::duration time)
  {
    return std::chrono::duration<double, std::milli>(time).count();
  }

  Clock::time_point End, TaskStart, TaskEnd;
  int Tasks;
};

#endif
