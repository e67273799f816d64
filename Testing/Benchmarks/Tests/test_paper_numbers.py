# SPDX-License-Identifier: BSD-3-Clause
"""That the paper's numbers are told as they stand there: sums that it gives itself, and tables that agree
with each other."""

import unittest

from shadow_report.paper_numbers import FRAME_TIMES, SCENES, STAGE_TIMES, paper_ratio


class PaperNumbers(unittest.TestCase):
    def test_stages_add_up_to_the_totals(self):
        self.assertEqual(len(STAGE_TIMES), 4)
        for s in STAGE_TIMES:
            rest = s.importance_map + s.warping_map + s.output
            self.assertAlmostEqual(rest + s.shadow_map, s.total, msg=s.name)
            tessellated = rest + s.tessellated_shadow_map if s.tessellated_total else 0
            self.assertAlmostEqual(tessellated, s.tessellated_total, msg=s.name)

    # The view of figure 1 is one of the playground.
    def test_totals_of_table_2_lie_in_the_ranges_of_table_1(self):
        ranges = {row.variant: row.scenes[0] for row in FRAME_TIMES if row.table == 1}
        for s in STAGE_TIMES:
            least, most = ranges[s.variant]
            self.assertTrue(least <= s.total <= most, s.name)

    def test_rows_are_those_of_the_paper(self):
        self.assertEqual(len({(row.table, row.variant) for row in FRAME_TIMES}), 11)
        for row in FRAME_TIMES:
            self.assertTrue(all(least < most for least, most in row.scenes), row.name)

    # Table 3's column of 2.5 % is table 1's backward analysis with tessellation, measured again.
    def test_tables_1_and_3_agree_on_tessellation(self):
        for scene in SCENES:
            first = paper_ratio(1, "backward+tessellated-2.5", scene)
            self.assertLess(abs(paper_ratio(3, "backward+tessellated-2.5", scene) - first), 0.06 * first)
            self.assertLess(paper_ratio(3, "backward+tessellated-5", scene), first)
            self.assertLess(paper_ratio(3, "backward+linear", scene),
                            paper_ratio(3, "backward+tessellated-5", scene))

    def test_ratios_are_times_of_the_conventional_map(self):
        self.assertEqual(paper_ratio(1, "conventional", "town"), 1)
        self.assertAlmostEqual(paper_ratio(1, "hybrid+linear", "sandbox"), 5.35 / 2.0)
        self.assertAlmostEqual(paper_ratio(3, "backward+tessellated-1", "town"), 16.95 / 2.95)
        self.assertIsNone(paper_ratio(3, "hybrid+linear", "town"))
        self.assertIsNone(paper_ratio(1, "backward+linear", "duel"))


if __name__ == "__main__":
    unittest.main()
