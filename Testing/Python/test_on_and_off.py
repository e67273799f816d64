# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on and off, over and over, in chains that change: memory and GL objects stay.

RTW_ON_AND_OFF says how often; where it isn't set, a few hundred times.
"""

import ctypes
import gc
import os
import sys
import unittest

import rtwshadows
from stage import add_actor, add_pane, ball, make_renderer, make_window
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkEDLShading,
    vtkOpenGLFXAAPass,
    vtkRenderStepsPass,
    vtkSSAOPass,
)

TIMES = int(os.environ.get("RTW_ON_AND_OFF", "200"))


def find_gl():
    """The library that the process has loaded OpenGL's functions from, or another of its kind."""
    for name in ("libGL.so.1", "libOpenGL.so.0", "libGLX_mesa.so.0"):
        try:
            return ctypes.CDLL(name)
        except OSError:
            continue
    return None


# What glIs... exists for, by the names that are asked for.
KINDS = ("Texture", "Buffer", "Framebuffer", "Renderbuffer", "VertexArray", "Query", "Program",
         "Shader", "Sampler", "TransformFeedback", "ProgramPipeline")


def count_objects(gl, up_to=6000):
    """How many GL objects of each kind there are: names are small numbers, given out again."""
    counts = {}
    for kind in KINDS:
        ask = getattr(gl, "glIs" + kind, None)
        if ask is not None:
            ask.restype = ctypes.c_ubyte
            ask.argtypes = [ctypes.c_uint]
            counts[kind] = sum(ask(name) for name in range(1, up_to))
    return counts


def resident():
    """Bytes of memory that the process has in use."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def around(outer, inner):
    outer.SetDelegatePass(inner)
    return outer


CHAINS = (
    lambda: None,
    vtkRenderStepsPass,
    lambda: around(vtkSSAOPass(), vtkRenderStepsPass()),
    lambda: around(vtkOpenGLFXAAPass(), vtkRenderStepsPass()),
    lambda: around(vtkEDLShading(), vtkRenderStepsPass()),
    lambda: around(vtkOpenGLFXAAPass(), around(vtkSSAOPass(), vtkRenderStepsPass())),
)


class TestOnAndOff(unittest.TestCase):
    def setUp(self):
        self.renderers = [make_renderer(), make_renderer()]
        add_pane(self.renderers[1])
        for i, renderer in enumerate(self.renderers):
            renderer.SetViewport(i / 2, 0, (i + 1) / 2, 1)
            add_actor(renderer, ball((1, 1, 1), 0.3, 8))
        self.window = make_window(*self.renderers, size=(64, 32))
        self.techniques = rtwshadows.available_techniques()

    def set_chain(self, renderer, chain):
        old = renderer.GetPass()
        renderer.SetPass(chain)
        if old is not None:
            old.ReleaseGraphicsResources(self.window)

    def once(self, i):
        """One of all combinations of chain, technique, resolution and renderer, in an order in
        which each follows many others."""
        renderer = self.renderers[i % 2]
        technique = self.techniques[i % len(self.techniques)]
        self.set_chain(renderer, CHAINS[(i // 3) % len(CHAINS)]())
        shadows = rtwshadows.enable_shadows(
            renderer, technique, (16, 32, 64)[i % 3],
            light=(None, "sun", None, "lamp", "camera-left")[i % 5])
        self.window.Render()
        if i % 7 == 0:
            shadows.SetResolution(24)
            shadows.SetFilterToPCF()
            self.window.Render()
        if i % 4 == 1:  # wrapped since
            renderer.SetPass(around(vtkOpenGLFXAAPass(), renderer.GetPass()))
            self.window.Render()
        if i % 11 == 0:  # replaced without switching off
            rtwshadows.enable_shadows(renderer, "uniform", 16)
            self.window.Render()
        if i % 3:
            rtwshadows.disable_shadows(renderer)
            self.window.Render()

    def end(self):
        """Everything as it was at first."""
        rtwshadows.disable_shadows(self.window)
        for renderer in self.renderers:
            self.set_chain(renderer, None)
        self.window.Render()
        gc.collect()

    def test_memory_and_objects_stay(self):
        gl = find_gl()
        if gl is None or not os.path.exists("/proc/self/statm"):
            self.skipTest("needs the GL library by its usual name, and /proc")
        warm = 120  # each technique in each chain, both renderers: shaders are kept by VTK
        for i in range(warm):
            self.once(i)
        self.end()
        before, memory = count_objects(gl), resident()
        self.assertGreater(before["Texture"] + before["Buffer"], 2)  # the right context
        for i in range(warm, warm + TIMES):
            self.once(i)
        self.end()
        after = count_objects(gl)
        grown = resident() - memory
        print(f"{TIMES} times: {grown / 1024:.0f} KiB more; {before} then {after}")
        for kind, count in after.items():
            self.assertLessEqual(count, before[kind] + 2, kind)
        # The C library's heap isn't flat: a few pages a time would be a leak.
        self.assertLess(grown, 8 * 1024 * 1024 + 2 * 1024 * TIMES)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
