// SPDX-License-Identifier: BSD-3-Clause
#include "rtwCompare.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

namespace
{
// One character a pixel: L lit, S shadow, A averted, B background.
rtw::Truth MakeTruth(int width, const std::string& picture)
{
  rtw::Truth truth;
  truth.Width = width;
  truth.Height = int(picture.size()) / width;
  for (const char c : picture)
  {
    truth.Mask.push_back(c == 'L' ? rtw::MASK_LIT
        : c == 'S'                ? rtw::MASK_SHADOW
        : c == 'A'                ? rtw::MASK_AVERTED
                                  : rtw::MASK_BACKGROUND);
  }
  return truth;
}

std::array<int, 3> Pixel(vtkImageData* image, int x)
{
  const auto* p = static_cast<unsigned char*>(image->GetScalarPointer(x, 0, 0));
  return { p[0], p[1], p[2] };
}
}

TEST(Compare, TheTruthHasNoErrors)
{
  const rtw::Truth truth = MakeTruth(4, "LLSSAASSBBLL");
  const rtw::ShadowErrors errors = rtw::Compare(truth.Mask, truth);
  EXPECT_EQ(errors.LitFacing, 8u);
  EXPECT_EQ(errors.Shadowed, 4u);
  EXPECT_EQ(errors.Wrong(), 0u);
  EXPECT_EQ(errors.NotComparable, 0u);
  EXPECT_EQ(errors.Percent(errors.Shadowed), 50);
}

TEST(Compare, CountsEachKindOfError)
{
  const rtw::Truth truth = MakeTruth(8, "LLLSSSAB");
  const rtw::ShadowErrors errors = rtw::Compare({ 255, 0, 127, 0, 129, 128, 0, 0 }, truth);
  EXPECT_EQ(errors.LitFacing, 6u);
  EXPECT_EQ(errors.WronglyDark, 2u);
  EXPECT_EQ(errors.WronglyLit, 1u);
  EXPECT_EQ(errors.NotComparable, 1u);
  EXPECT_EQ(errors.Wrong(), 3u);
  EXPECT_EQ(errors.Percent(errors.Wrong()), 50);
}

TEST(Compare, AnEdgeIsBetweenLitAndShadowedNeighbours)
{
  EXPECT_EQ(rtw::Compare(std::vector<unsigned char>(6), MakeTruth(6, "LLSSAL")).AtEdge, 2u);
  EXPECT_EQ(rtw::Compare(std::vector<unsigned char>(6), MakeTruth(1, "LLSSAL")).AtEdge, 2u);
  // The right end of a row is not beside the left end of the next.
  EXPECT_EQ(rtw::Compare(std::vector<unsigned char>(6), MakeTruth(3, "LLSLLS")).AtEdge, 4u);
  EXPECT_EQ(rtw::Compare(std::vector<unsigned char>(4), MakeTruth(2, "LALS")).AtEdge, 2u);
}

TEST(Compare, FarIsMoreThanTwoPixelsFromAnEdge)
{
  // In a row, the edge is between pixels 4 and 5; all decisions are wrong.
  const rtw::Truth row = MakeTruth(10, "LLLLLSSSSS");
  std::vector<unsigned char> wrong{ 0, 0, 0, 0, 0, 255, 255, 255, 255, 255 };
  EXPECT_EQ(rtw::Compare(wrong, row).FarFromEdge, 4u); // pixels 0, 1, 8 and 9
  rtw::Truth column = row;
  std::swap(column.Width, column.Height);
  EXPECT_EQ(rtw::Compare(wrong, column).FarFromEdge, 4u);
  // One pixel in shadow in the middle of 9 x 9: it and its neighbours are the edge, so that a
  // diamond of pixels spreads to a square with cut corners.
  std::string picture(81, 'L');
  picture[40] = 'S';
  const rtw::Truth dot = MakeTruth(9, picture);
  const std::vector<unsigned char> dark(81, 0);
  const size_t near = 7 * 7 - 4;
  EXPECT_EQ(rtw::Compare(dark, dot).FarFromEdge, 81 - near);
  // Right decisions do not count, wherever they are.
  EXPECT_EQ(rtw::Compare(dot.Mask, dot).FarFromEdge, 0u);
}

TEST(Compare, TellsDarkFromLitNearAndFar)
{
  const rtw::Truth row = MakeTruth(10, "LLLLLSSSSS");
  const rtw::ShadowErrors errors =
    rtw::Compare({ 0, 255, 255, 255, 0, 255, 255, 0, 255, 255 }, row);
  EXPECT_EQ(errors.DarkFarFromEdge, 1u);
  EXPECT_EQ(errors.LitFarFromEdge(), 2u);
  EXPECT_EQ(errors.DarkNearEdge(), 1u);
  EXPECT_EQ(errors.LitNearEdge(), 2u);
  EXPECT_EQ(errors.NearEdge(), 3u);
}

TEST(Compare, ErrorsAddUp)
{
  const rtw::Truth row = MakeTruth(10, "LLLLLSSSSS");
  const std::vector<unsigned char> mask = { 0, 255, 255, 128, 0, 255, 255, 0, 255, 255 };
  const rtw::ShadowErrors once = rtw::Compare(mask, row);
  rtw::ShadowErrors thrice = once;
  (thrice += once) += once;
  const auto members = { &rtw::ShadowErrors::LitFacing, &rtw::ShadowErrors::Shadowed,
    &rtw::ShadowErrors::WronglyDark, &rtw::ShadowErrors::WronglyLit,
    &rtw::ShadowErrors::NotComparable, &rtw::ShadowErrors::FarFromEdge,
    &rtw::ShadowErrors::DarkFarFromEdge, &rtw::ShadowErrors::AtEdge };
  for (const auto member : members)
  {
    EXPECT_GT(once.*member, 0u);
    EXPECT_EQ(thrice.*member, 3 * (once.*member));
  }
  static_assert(sizeof(rtw::ShadowErrors) == 8 * sizeof(size_t), "each member is named above");
}

TEST(Compare, RefusesAMaskOfAnotherSize)
{
  EXPECT_THROW(rtw::Compare({ 255 }, MakeTruth(2, "LL")), std::invalid_argument);
  EXPECT_THROW(rtw::DifferenceImage({ 255 }, MakeTruth(2, "LL")), std::invalid_argument);
}

TEST(Compare, NothingFacingTheLightIsNoError)
{
  const rtw::ShadowErrors errors = rtw::Compare({ 0, 255 }, MakeTruth(2, "AB"));
  EXPECT_EQ(errors.LitFacing, 0u);
  EXPECT_EQ(errors.Percent(errors.Wrong()), 0);
}

TEST(Compare, TheDifferenceShowsWhatIsWrong)
{
  const auto image = rtw::DifferenceImage({ 255, 0, 0, 255, 128 }, MakeTruth(5, "LLSSS"));
  EXPECT_EQ(Pixel(image, 0), (std::array<int, 3>{ 235, 235, 235 }));
  EXPECT_EQ(Pixel(image, 1), (std::array<int, 3>{ 230, 0, 0 }));
  EXPECT_EQ(Pixel(image, 2), (std::array<int, 3>{ 90, 90, 90 }));
  EXPECT_EQ(Pixel(image, 3), (std::array<int, 3>{ 255, 150, 0 }));
  EXPECT_EQ(Pixel(image, 4), (std::array<int, 3>{ 0, 90, 255 }));
}

TEST(Compare, MasksBecomeImagesAndComeBack)
{
  const std::vector<unsigned char> mask{ 0, 1, 2, 3, 4, 255 };
  const auto image = rtw::MaskImage(mask, 3, 2);
  EXPECT_EQ(image->GetDimensions()[0], 3);
  EXPECT_EQ(image->GetDimensions()[1], 2);
  EXPECT_EQ(rtw::MaskOf(image), mask);
}
