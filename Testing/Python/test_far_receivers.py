# SPDX-License-Identifier: BSD-3-Clause
"""Eyes far from what they see, and all that is not looked up by our own view samples."""

import unittest

from far_scene import FAR, VIEWS, Scene, check


class TestFarReceivers(unittest.TestCase):
    def test_mappers(self):
        """What only VTK's mappers draw."""
        check(self, Scene(mapper=True), FAR)

    def test_translucent(self):
        """Receivers that look maps up themselves. A warp doesn't look at them, and leaves them few texels."""
        check(self, Scene(opacity=0.99), ("near", "1e5", "telephoto", "perspective"),
              ("uniform", "rtw", "exact"), bound=0.004)

    def test_samples(self):
        """Several samples a pixel: edges are grey there, and nothing else is wrong."""
        check(self, Scene(samples=4), FAR, ("rtw", "cascades", "exact"))

    def test_previous_frame(self):
        for technique in ("rtw", "cascades", "perspective"):
            scene = Scene()
            scene.use(technique, view_sample_source="previous_frame")
            for name in FAR:
                scene.look(**VIEWS[name])
                scene.draw()
                wrong = scene.wrong()
                with self.subTest(technique=technique, view=name):
                    self.assertLessEqual(wrong, 0.002)


if __name__ == "__main__":
    unittest.main()
