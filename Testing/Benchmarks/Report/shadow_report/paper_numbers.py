# SPDX-License-Identifier: BSD-3-Clause
"""What P. Rosen, Rectilinear Texture Warping for Fast Adaptive Shadow Mapping, 2012, measured on a
GeForce GTX 480 at 1920 x 1080 pixels: all of its tables, in milliseconds."""

from collections import namedtuple

SCENES = ("playground", "sandbox", "town")

# A row of table 1, or a column of table 3: its name in the paper, the variant of the family "paper",
# and the least and the most of the frames along each scene's path.
FrameTimes = namedtuple("FrameTimes", "table name variant scenes")

# The paper does not say how long the tessellated edges of table 1 are. They take what 2.5 % take in
# table 3, which it recommends (section 6.1).
FRAME_TIMES = tuple(FrameTimes(*row) for row in (
    (1, "Conventional", "conventional", ((2.7, 3.6), (1.9, 2.1), (2.7, 3.2))),
    (1, "Forward Analysis", "forward+linear", ((5.3, 7.0), (4.2, 5.3), (3.7, 4.8))),
    (1, "(Dynamic Tessellation)", "forward+tessellated-2.5", ((7.2, 8.4), (5.8, 7.2), (11.0, 11.8))),
    (1, "Backward Analysis", "backward+linear", ((4.2, 5.9), (4.0, 5.4), (3.7, 4.8))),
    (1, "(Dynamic Tessellation)", "backward+tessellated-2.5", ((6.2, 7.3), (6.2, 7.1), (11.0, 11.5))),
    (1, "Hybrid Analysis", "hybrid+linear", ((5.8, 7.3), (5.0, 5.7), (4.5, 5.4))),
    (1, "(Dynamic Tessellation)", "hybrid+tessellated-2.5", ((7.8, 8.9), (6.5, 7.2), (11.8, 12.5))),
    (3, "Disabled", "backward+linear", ((4.3, 5.4), (3.8, 4.8), (3.8, 5.0))),
    (3, "5%", "backward+tessellated-5", ((5.5, 6.9), (5.2, 5.9), (8.4, 9.5))),
    (3, "2.5%", "backward+tessellated-2.5", ((5.8, 7.0), (5.9, 7.0), (10.9, 11.9))),
    (3, "1%", "backward+tessellated-1", ((6.0, 7.2), (8.0, 9.5), (16.5, 17.4)))))

# A column of table 2, of the view of figure 1, which is one of the playground: stages (a) to (d).
# Stages that there are none of take 0.
StageTimes = namedtuple(
    "StageTimes", "name variant tessellated importance_map warping_map shadow_map output total "
                  "tessellated_shadow_map tessellated_total")
STAGE_TIMES = tuple(StageTimes(*column) for column in (
    ("Conventional", "conventional", "", 0, 0, 1.3, 1.8, 3.1, 0, 0),
    ("Forward Analysis", "forward+linear", "forward+tessellated-2.5", 1.3, 0.1, 2.2, 1.9, 5.5, 3.6, 6.9),
    ("Backward Analysis", "backward+linear", "backward+tessellated-2.5", 1.4, 0.3, 2.2, 0.9, 4.8, 3.9, 6.5),
    ("Hybrid Analysis", "hybrid+linear", "hybrid+tessellated-2.5", 2.7, 0.4, 2.0, 1.1, 6.2, 3.6, 7.8)))


def paper_ratio(table, variant, scene):
    """Of a table's variant, in times of the conventional map's frame; None if the paper has none.

    Ranges stand for their middle. Table 3 has no conventional map, so that table 1's is taken.
    """
    def find(number, name):
        return next((row for row in FRAME_TIMES if row.table == number and row.variant == name), None)

    row = find(table, variant)
    if row is None or scene not in SCENES:
        return None
    column = SCENES.index(scene)
    return sum(row.scenes[column]) / sum(find(1, "conventional").scenes[column])
