// SPDX-License-Identifier: BSD-3-Clause
#include "rtwFlicker.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
constexpr unsigned char LIT = rtw::MASK_LIT, DARK = rtw::MASK_SHADOW, NONE = rtw::MASK_AVERTED;

rtw::Truth MakeTruth(const std::vector<unsigned char>& mask, int width = 4)
{
  rtw::Truth truth;
  truth.Width = width;
  truth.Height = int(mask.size()) / width;
  truth.Mask = mask;
  return truth;
}
}

TEST(Flicker, IsNothingInSteadyFrames)
{
  rtw::Flicker flicker;
  EXPECT_EQ(flicker.MeanPercent(), 0);
  EXPECT_EQ(flicker.GreatestPercent(), 0);
  const rtw::Truth truth = MakeTruth({ LIT, LIT, DARK, DARK });
  for (int frame = 0; frame < 3; ++frame)
  {
    flicker.Add({ 255, 20, 0, 200 }, truth); // wrong, but steadily so
  }
  EXPECT_EQ(flicker.Percents(), std::vector<double>({ 0, 0 }));
}

TEST(Flicker, CountsDecisionsThatChangeThoughTheTruthStays)
{
  rtw::Flicker flicker;
  flicker.Add({ 255, 255, 0, 0 }, MakeTruth({ LIT, LIT, DARK, DARK }));
  flicker.Add({ 255, 100, 0, 0 }, MakeTruth({ LIT, LIT, DARK, DARK }));  // one of four
  flicker.Add({ 0, 255, 255, 0 }, MakeTruth({ DARK, LIT, DARK, DARK })); // two of three
  EXPECT_EQ(flicker.Percents(), std::vector<double>({ 25, 200.0 / 3 }));
  EXPECT_EQ(flicker.MeanPercent(), (25 + 200.0 / 3) / 2);
  EXPECT_EQ(flicker.GreatestPercent(), 200.0 / 3);
}

TEST(Flicker, LeavesOutWhatTheTruthChanges)
{
  rtw::Flicker flicker;
  flicker.Add({ 255, 255, 0, 0 }, MakeTruth({ LIT, LIT, NONE, rtw::MASK_BACKGROUND }));
  flicker.Add({ 0, 255, 255, 255 }, MakeTruth({ DARK, LIT, NONE, rtw::MASK_BACKGROUND }));
  EXPECT_EQ(flicker.GreatestPercent(), 0);
  // Nothing stays at all.
  flicker.Add({ 255, 0, 0, 0 }, MakeTruth({ LIT, DARK, LIT, LIT }));
  EXPECT_EQ(flicker.Percents().back(), 0);
}

TEST(Flicker, NoDecisionIsNoChange)
{
  rtw::Flicker flicker;
  const rtw::Truth truth = MakeTruth({ LIT, LIT, DARK, DARK });
  flicker.Add({ 255, 128, 0, 127 }, truth);
  flicker.Add({ 128, 255, 128, 129 }, truth);
  EXPECT_EQ(flicker.Percents(), std::vector<double>({ 25 }));
}

TEST(Flicker, LeavesOutStepsBetweenPaths)
{
  rtw::Flicker flicker;
  const rtw::Truth truth = MakeTruth({ LIT, LIT, DARK, DARK });
  flicker.Add({ 255, 255, 0, 0 }, truth);
  flicker.StartAnew();
  flicker.Add({ 0, 0, 0, 0 }, truth);
  EXPECT_TRUE(flicker.Percents().empty());
  flicker.Add({ 255, 0, 0, 0 }, truth);
  EXPECT_EQ(flicker.Percents(), std::vector<double>({ 25 }));
}

TEST(Flicker, FramesOfAnotherSizeStartAnew)
{
  rtw::Flicker flicker;
  flicker.Add({ 255, 255, 0, 0 }, MakeTruth({ LIT, LIT, DARK, DARK }));
  flicker.Add({ 0, 0, 0, 0 }, MakeTruth({ LIT, LIT, DARK, DARK }, 2));
  flicker.Add({ 0, 0 }, MakeTruth({ LIT, LIT }, 2));
  EXPECT_TRUE(flicker.Percents().empty());
  EXPECT_THROW(flicker.Add({ 0 }, MakeTruth({ LIT, LIT }, 2)), std::invalid_argument);
}
