// SPDX-License-Identifier: BSD-3-Clause
// That the paper's numbers are told as they stand there: sums that it gives itself, and tables that
// agree with each other.
#include "PaperNumbers.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

TEST(PaperNumbers, StagesAddUpToTheTotals)
{
  ASSERT_EQ(PaperStageTimes().size(), 4u);
  for (const PaperStages& s : PaperStageTimes())
  {
    const double rest = s.ImportanceMap + s.WarpingMap + s.Output;
    EXPECT_NEAR(rest + s.ShadowMap, s.Total, 1e-9) << s.Name;
    EXPECT_NEAR(
      s.TessellatedTotal > 0 ? rest + s.TessellatedShadowMap : 0, s.TessellatedTotal, 1e-9)
      << s.Name;
  }
}

// The view of figure 1 is one of the playground.
TEST(PaperNumbers, TotalsOfTable2LieInTheRangesOfTable1)
{
  for (const PaperStages& s : PaperStageTimes())
  {
    for (const PaperTimes& times : PaperFrameTimes())
    {
      if (times.Table == 1 && times.Variant == std::string(s.Variant))
      {
        EXPECT_GE(s.Total, times.Scenes[0].Least) << s.Name;
        EXPECT_LE(s.Total, times.Scenes[0].Most) << s.Name;
      }
    }
  }
}

TEST(PaperNumbers, RowsAreThoseOfThePaper)
{
  std::set<std::pair<int, std::string>> rows;
  for (const PaperTimes& times : PaperFrameTimes())
  {
    rows.emplace(times.Table, times.Variant);
    for (const PaperRange& range : times.Scenes)
    {
      EXPECT_LT(range.Least, range.Most) << times.Name;
    }
  }
  EXPECT_EQ(rows.size(), 11u);
}

// Table 3's column of 2.5 % is table 1's backward analysis with tessellation, measured again.
TEST(PaperNumbers, Tables1And3AgreeOnTessellation)
{
  for (const char* scene : PAPER_SCENES)
  {
    const double first = PaperRatio(1, "backward+tessellated-2.5", scene).value();
    EXPECT_NEAR(PaperRatio(3, "backward+tessellated-2.5", scene).value(), first, 0.06 * first);
    EXPECT_LT(PaperRatio(3, "backward+tessellated-5", scene).value(), first);
    EXPECT_LT(PaperRatio(3, "backward+linear", scene).value(),
      PaperRatio(3, "backward+tessellated-5", scene).value());
  }
}

TEST(PaperNumbers, RatiosAreTimesOfTheConventionalMap)
{
  EXPECT_DOUBLE_EQ(PaperRatio(1, "conventional", "town").value(), 1);
  EXPECT_NEAR(PaperRatio(1, "hybrid+linear", "sandbox").value(), 5.35 / 2.0, 1e-9);
  EXPECT_NEAR(PaperRatio(3, "backward+tessellated-1", "town").value(), 16.95 / 2.95, 1e-9);
  EXPECT_FALSE(PaperRatio(3, "hybrid+linear", "town"));
  EXPECT_FALSE(PaperRatio(1, "backward+linear", "duel"));
}
