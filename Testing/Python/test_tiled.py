# SPDX-License-Identifier: BSD-3-Clause
"""A screenshot of several tiles shows what one large window shows."""

import sys
import unittest

from ball_on_floor import TECHNIQUES, Stage, differing, rtwshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


def screenshot(stage, scale):
    grab = vtkWindowToImageFilter()
    grab.SetInput(stage.window)
    grab.SetScale(scale)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).astype(int).reshape(height, width, 3)


class TestTiled(unittest.TestCase):
    def test_every_technique(self):
        for technique in TECHNIQUES:
            for scale in (2, 3):
                large = Stage((80 * scale, 60 * scale))
                without = large.picture()
                rtwshadows.enable_shadows(large.renderer, technique, 512)
                right = large.picture()
                stage = Stage((80, 60))
                rtwshadows.enable_shadows(stage.renderer, technique, 512)
                wrong = differing(screenshot(stage, scale), right, 30)
                # Each tile has maps of its own, whose texels meet the shadow's edge elsewhere.
                most = 0 if technique == "exact" else 0.1 * differing(without, right, 30)
                self.assertLessEqual(wrong, most, f"{technique} × {scale}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
