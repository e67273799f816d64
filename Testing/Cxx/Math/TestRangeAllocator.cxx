// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwRangeAllocator.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <map>
#include <random>

namespace
{
TEST(RangeAllocator, GrowsAtItsEnd)
{
  rtw::RangeAllocator ranges;
  EXPECT_EQ(ranges.Allocate(10), 0u);
  EXPECT_EQ(ranges.Allocate(5), 10u);
  EXPECT_EQ(ranges.GetEnd(), 15u);
}

TEST(RangeAllocator, UsesTheFirstGapThatFits)
{
  rtw::RangeAllocator ranges;
  const std::size_t a = ranges.Allocate(4);
  ranges.Allocate(1);
  const std::size_t b = ranges.Allocate(8);
  ranges.Allocate(1);
  ranges.Free(a, 4);
  ranges.Free(b, 8);
  EXPECT_EQ(ranges.Allocate(6), b);
  EXPECT_EQ(ranges.Allocate(4), a);
  EXPECT_EQ(ranges.Allocate(2), b + 6);
  EXPECT_EQ(ranges.GetEnd(), 14u);
}

TEST(RangeAllocator, JoinsGapsWhateverTheOrder)
{
  for (const int first : { 0, 1, 2 })
  {
    rtw::RangeAllocator ranges;
    std::size_t starts[3];
    for (std::size_t& start : starts)
    {
      start = ranges.Allocate(3);
    }
    const std::size_t last = ranges.Allocate(1);
    for (int i = 0; i < 3; ++i)
    {
      ranges.Free(starts[(first + i) % 3], 3);
    }
    EXPECT_EQ(ranges.Allocate(9), 0u);
    ranges.Free(last, 1);
    EXPECT_EQ(ranges.GetEnd(), 9u);
  }
}

TEST(RangeAllocator, IsEmptyWhenAllIsGivenBack)
{
  rtw::RangeAllocator ranges;
  const std::size_t a = ranges.Allocate(3);
  const std::size_t b = ranges.Allocate(7);
  ranges.Free(a, 3);
  ranges.Free(b, 7);
  EXPECT_EQ(ranges.GetEnd(), 0u);
  ranges.Allocate(2);
  ranges.Clear();
  EXPECT_EQ(ranges.GetEnd(), 0u);
  EXPECT_EQ(ranges.Allocate(1), 0u);
}

TEST(RangeAllocator, RangesNeverOverlap)
{
  rtw::RangeAllocator ranges;
  std::map<std::size_t, std::size_t> held; // count by start
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i)
  {
    if (held.size() > 40 || (!held.empty() && random() % 2))
    {
      const auto it = std::next(held.begin(), static_cast<long>(random() % held.size()));
      ranges.Free(it->first, it->second);
      held.erase(it);
      continue;
    }
    const std::size_t count = 1 + random() % 30;
    const auto it = held.emplace(ranges.Allocate(count), count).first;
    ASSERT_EQ(it->second, count);
    if (it != held.begin())
    {
      const auto before = std::prev(it);
      ASSERT_LE(before->first + before->second, it->first);
    }
    if (std::next(it) != held.end())
    {
      ASSERT_LE(it->first + count, std::next(it)->first);
    }
    ASSERT_LE(it->first + count, ranges.GetEnd());
  }
}
}
