# SPDX-License-Identifier: BSD-3-Clause
"""Warps, partitions and settings of a pass that lives on, changed over and over: memory and GL
objects stay.

RTW_CHANGES says how often, where it is set.
"""

import gc
import os
import random
import sys
import unittest

import rtwshadows
from resources import count_gl_objects, find_gl, heap_in_use, resident
from stage import make_renderer, make_window

TIMES = int(os.environ.get("RTW_CHANGES", "200"))

# So many changes come again and again: VTK keeps each program that it has built, and the driver what
# it made of it.
CYCLE = 50
# Drivers count on where they name programs.
NAMES = 50000


def rectilinear(dice):
    warp = rtwshadows.vtkRectilinearShadowMapWarp()
    warp.SetImportanceResolution(dice.choice((32, 64)))
    return warp


def non_orthogonal(dice):
    warp = rtwshadows.vtkNonOrthogonalShadowMapWarp()
    warp.SetImportanceResolution(dice.choice((64, 128)))
    return warp


def perspective(dice):
    warp = rtwshadows.vtkPerspectiveShadowMapWarp()
    warp.SetResolutionSplit(dice.randrange(2))
    return warp


def identity(_dice):
    return rtwshadows.vtkIdentityShadowMapWarp()


def depth_splits(dice):
    partition = rtwshadows.vtkDepthSplitShadowMapPartition()
    partition.SetNumberOfLayers(dice.choice((2, 3)))
    partition.SetSplitScheme(dice.randrange(4))
    return partition


def whole_view(_dice):
    return rtwshadows.vtkShadowMapPartition()


WARPS = (rectilinear, non_orthogonal, perspective, identity)
PARTITIONS = (depth_splits, whole_view)


def change(shadows, dice):
    """One thing of a pass, which alone keeps its warp and its partition alive."""
    what = dice.randrange(4)
    if what == 0:
        shadows.SetWarp(dice.choice(WARPS)(dice))
    elif what == 1:
        shadows.SetPartition(dice.choice(PARTITIONS)(dice))
    elif what == 2:
        shadows.SetFilter(dice.randrange(2))
        shadows.SetRasterization(dice.randrange(3))
        shadows.SetCullCasters(bool(dice.randrange(2)))
    else:
        shadows.SetResolution(dice.choice((16, 32, 64)))


def reset(shadows):
    shadows.SetWarp(identity(None))
    shadows.SetPartition(whole_view(None))
    shadows.SetFilter(0)
    shadows.SetRasterization(0)
    shadows.SetCullCasters(True)
    shadows.SetResolution(32)


def cycle(shadows, window):
    dice = random.Random(7)
    for _ in range(CYCLE):
        change(shadows, dice)
        window.Render()
    reset(shadows)
    window.Render()
    gc.collect()


class TestChanges(unittest.TestCase):
    def check(self, technique, times, most):
        gl = find_gl()
        if gl is None:
            self.skipTest("the GL library isn't found by its usual names")
        renderer = make_renderer()
        window = make_window(renderer, size=(32, 32))
        shadows = rtwshadows.enable_shadows(renderer, technique, 32)
        cycle(shadows, window)
        before = count_gl_objects(gl, NAMES), heap_in_use(), resident()
        self.assertGreater(before[0]["Texture"] + before[0]["Buffer"], 2)  # the right context
        for _ in range(max(1, times // CYCLE)):
            cycle(shadows, window)
        after = count_gl_objects(gl, NAMES), heap_in_use(), resident()
        print(f"{technique}, {times} changes: GL objects {before[0]}, then {after[0]}; "
              f"heap {before[1]}, then {after[1]}; resident {before[2]}, then {after[2]}")
        late = {"Query": 8}  # by which VTK times its mappers now and then
        for kind, count in after[0].items():
            self.assertLessEqual(count, before[0][kind] + late.get(kind, 0), kind)
        if before[1] is not None:
            self.assertLess(after[1] - before[1], most)
        if before[2] is not None:
            self.assertLess(after[2] - before[2], most + (16 << 20))

    def test_maps(self):
        self.check("cascades", TIMES, 4 << 20)

    def test_exact_shadows(self):
        if "exact" not in rtwshadows.available_techniques():
            self.skipTest("not in this build")
        self.check("exact", TIMES // 2, 64 << 20)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
