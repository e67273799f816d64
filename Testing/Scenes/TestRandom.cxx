// SPDX-License-Identifier: BSD-3-Clause
#include "rtwRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// The expected values are what numpy 1.24 gives for default_rng(seed).
using rtw::Random;

TEST(Random, Bits)
{
  Random one(1), seven(7), largest(0xffffffffu);
  EXPECT_EQ(one.Bits(), 0x8306bdf37922e4ffu);
  EXPECT_EQ(one.Bits(), 0xf35196bbc152a866u);
  EXPECT_EQ(seven.Bits(), 0xa00641a9f1e54a8bu);
  EXPECT_EQ(seven.Bits(), 0xe5afcdbcaf266a95u);
  EXPECT_EQ(largest.Bits(), 0x407f5fa930d8fd9fu);
  EXPECT_EQ(largest.Bits(), 0x3814b22eb9684802u);
}

TEST(Random, Uniform)
{
  Random random(1);
  EXPECT_DOUBLE_EQ(random.Uniform(-2, 5), 1.582751372901797);
  EXPECT_DOUBLE_EQ(random.Uniform(-2, 5), 4.653245874281547);
  EXPECT_DOUBLE_EQ(random.Uniform(-2, 5), -0.990882710962564);
}

TEST(Random, Normal)
{
  Random random(7);
  EXPECT_NEAR(random.Normal(), 0.0012301533574825742, 1e-15);
  EXPECT_NEAR(random.Normal(), 0.2987455375084699, 1e-14);
  EXPECT_NEAR(random.Normal(), -0.2741378553622176, 1e-14);
}

// Goes through every branch of the ziggurat, the tail included: one wrong turn and the sum and the
// number after it are others.
TEST(Random, ManyNormals)
{
  Random random(7);
  double sum = 0, largest = 0;
  for (int i = 0; i < 1000000; ++i)
  {
    const double x = random.Normal();
    sum += x;
    largest = std::max(largest, std::abs(x));
  }
  EXPECT_NEAR(sum, -112.78554893201773, 1e-8);
  EXPECT_NEAR(largest, 4.947871460149176, 1e-12);
  EXPECT_DOUBLE_EQ(random.Uniform(), 0.1291022438369006);
}
