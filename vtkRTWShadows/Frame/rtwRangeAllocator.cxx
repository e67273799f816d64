// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwRangeAllocator.h"

#include <iterator>

namespace rtw
{
std::size_t RangeAllocator::Allocate(std::size_t count)
{
  for (auto gap = this->Gaps.begin(); gap != this->Gaps.end(); ++gap)
  {
    const auto [start, size] = *gap;
    if (size >= count)
    {
      this->Gaps.erase(gap);
      if (size > count)
      {
        this->Gaps[start + count] = size - count;
      }
      return start;
    }
  }
  const std::size_t start = this->End;
  this->End += count;
  return start;
}

void RangeAllocator::Free(std::size_t start, std::size_t count)
{
  if (count == 0)
  {
    return;
  }
  auto after = this->Gaps.lower_bound(start);
  if (after != this->Gaps.end() && after->first == start + count)
  {
    count += after->second;
    after = this->Gaps.erase(after);
  }
  if (after != this->Gaps.begin())
  {
    const auto before = std::prev(after);
    if (before->first + before->second == start)
    {
      start = before->first;
      count += before->second;
      this->Gaps.erase(before);
    }
  }
  if (start + count == this->End)
  {
    this->End = start;
  }
  else
  {
    this->Gaps[start] = count;
  }
}

void RangeAllocator::Clear()
{
  this->Gaps.clear();
  this->End = 0;
}
}
