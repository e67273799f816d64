# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on and off, over and over, in chains that change: memory and GL objects stay.

RTW_ON_AND_OFF says how often, where it is set: 1000 takes minutes.
"""

import gc
import os
import random
import sys
import unittest

import rtwshadows
from resources import count_gl_objects, find_gl, heap_in_use, resident
from stage import add_actor, add_pane, ball, make_renderer, make_window
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderPass
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkEDLShading,
    vtkOpenGLFXAAPass,
    vtkRenderStepsPass,
    vtkSSAOPass,
)

TIMES = int(os.environ.get("RTW_ON_AND_OFF", "200"))


def count_python_objects():
    every = gc.get_objects()
    return sum(isinstance(one, (vtkRenderPass, vtkLight)) for one in every)


def around(outer, inner):
    outer.SetDelegatePass(inner)
    return outer


def none():
    return None


def ssao():
    return around(vtkSSAOPass(), vtkRenderStepsPass())


def fxaa():
    return around(vtkOpenGLFXAAPass(), vtkRenderStepsPass())


def edl():
    return around(vtkEDLShading(), vtkRenderStepsPass())


def fxaa_of_ssao():
    return around(vtkOpenGLFXAAPass(), ssao())


# Chain, technique, resolution, light, and what becomes of it while shadows are on.
MIXED = (
    (none, "uniform", 16, None, "wrapped"),
    (vtkRenderStepsPass, "rtw", 32, "sun", ""),
    (ssao, "uniform", 32, None, "resolution"),
    (fxaa, "rtw", 16, "lamp", ""),
    (edl, "perspective", 64, None, "technique"),
    (fxaa_of_ssao, "cascades", 16, "camera-left", ""),
    (none, "rtw", 16, "sun", "resolution"),
    (vtkRenderStepsPass, "notw", 16, None, ""),
    (ssao, "rtw", 16, None, "wrapped"),
    (fxaa, "perspective", 32, None, ""),
    (edl, "uniform", 64, "lamp", "unwrapped"),
    (fxaa_of_ssao, "rtw", 64, None, "left on"),
)
# Apart, because Mesa holds on to a few of their buffers of 25 MB, which are deleted, for some time.
EXACT = (
    (none, "exact", 16, "sun", ""),
    (ssao, "exact", 16, None, "wrapped"),
    (fxaa, "exact", 32, "lamp", "technique"),
)


class TestOnAndOff(unittest.TestCase):
    def setUp(self):
        self.renderers = [make_renderer(), make_renderer()]
        add_pane(self.renderers[1])
        for i, renderer in enumerate(self.renderers):
            renderer.SetViewport(i / 2, 0, (i + 1) / 2, 1)
            add_actor(renderer, ball((1, 1, 1), 0.3, 8))
        self.window = make_window(*self.renderers, size=(64, 32))

    def set_chain(self, renderer, chain):
        old = renderer.GetPass()
        renderer.SetPass(chain)
        if old is not None:
            old.ReleaseGraphicsResources(self.window)

    def once(self, renderer, chain, technique, resolution, light, what):
        self.set_chain(renderer, chain())
        shadows = rtwshadows.enable_shadows(renderer, technique, resolution, light=light)
        self.window.Render()
        if what == "resolution":
            shadows.SetResolution(24)
            self.window.Render()
        elif what == "technique":
            rtwshadows.enable_shadows(renderer, "uniform", 16, light="lamp")
            self.window.Render()
        elif what == "wrapped":
            renderer.SetPass(around(vtkOpenGLFXAAPass(), renderer.GetPass()))
            self.window.Render()
        elif what == "unwrapped":
            self.set_chain(renderer, None)
            self.window.Render()
        if what != "left on":
            rtwshadows.disable_shadows(renderer)
            self.window.Render()

    def end(self):
        """Everything as it was at first."""
        rtwshadows.disable_shadows(self.window)
        for renderer in self.renderers:
            self.set_chain(renderer, None)
        self.window.Render()
        gc.collect()

    def go(self, mixed, choices):
        for which, renderer in choices:
            self.once(self.renderers[renderer], *mixed[which])
        self.end()

    def check(self, mixed, times, most):
        gl = find_gl()
        if gl is None:
            self.skipTest("the GL library isn't found by its usual names")
        # VTK keeps each program that it has built, and the driver what it made of it.
        both = [(i, renderer) for i in range(len(mixed)) for renderer in range(2)]
        self.go(mixed, both + both)
        before = count_gl_objects(gl), count_python_objects(), heap_in_use(), resident()
        self.assertGreater(before[0]["Texture"] + before[0]["Buffer"], 2)  # the right context
        dice = random.Random(19)
        self.go(mixed, [(dice.randrange(len(mixed)), dice.randrange(2)) for _ in range(times)])
        after = count_gl_objects(gl), count_python_objects(), heap_in_use(), resident()
        print(f"{times} times: GL objects {sum(before[0].values())}, "
              f"then {sum(after[0].values())}; passes and lights {before[1]}, then {after[1]}; "
              f"heap {before[2]}, then {after[2]}; resident {before[3]}, then {after[3]}")
        # What VTK makes once, some of it late: variants of programs, which it keeps, and two queries
        # of each of the seven mappers, by which it times them now and then.
        late = {"Program": 8, "Shader": 8, "Query": 14}
        for kind, count in after[0].items():
            self.assertLessEqual(count, before[0][kind] + late.get(kind, 0), kind)
        self.assertEqual(after[1], before[1])
        if before[2] is not None:
            self.assertLess(after[2] - before[2], most)
        if before[3] is not None:
            self.assertLess(after[3] - before[3], most + (16 << 20))

    def test_memory_and_objects_stay(self):
        """All but what late programs take; a pass that stays alive has more than 5 kB."""
        self.check(MIXED, TIMES, (1 << 20) + 5000 * TIMES)

    def test_exact_shadows(self):
        if "exact" not in rtwshadows.available_techniques():
            self.skipTest("not in this build")
        self.check(EXACT, max(20, TIMES // 10), 128 << 20)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
