# SPDX-License-Identifier: BSD-3-Clause
"""Eyes far from what they see: shadows are those of a near view."""

import unittest

from far_scene import TECHNIQUES, VIEWS, Scene, check


class TestFarEyes(unittest.TestCase):
    def test_eyes(self):
        check(self, Scene(), VIEWS)

    def test_same_mask(self):
        """A parallel camera's distance doesn't matter: but where rounding decides, at edges."""
        scene = Scene()
        for technique in TECHNIQUES:
            scene.use(technique)
            scene.look(20)
            scene.draw()
            near = scene.mask()
            scene.look(1e5)
            scene.draw()
            differing = ((near < 128) != (scene.mask() < 128)).sum()
            with self.subTest(technique=technique):
                self.assertGreater((near < 128).sum(), 500)
                self.assertLessEqual(differing, 8)

    def test_debug_views(self):
        """They cover the same pixels, in the same colours but for roundings."""
        scene = Scene()
        scene.use("cascades")
        for view in ("Shadow", "AliasingError", "Layers"):
            getattr(scene.shadows, "SetDebugViewTo" + view)()
            scene.look(20)
            near = scene.draw()
            scene.look(1e5)
            differing = (abs(scene.draw() - near).max(-1) > 40).mean()
            with self.subTest(view=view):
                self.assertLessEqual(differing, 0.003)

    def test_intervals(self):
        """Cascades divide what is seen, from wherever it is seen; distances are from the camera."""
        scene = Scene()
        scene.use("cascades")
        for distance in (20, 1e5):
            scene.look(distance)
            scene.draw()
            for layer in range(1, scene.shadows.GetNumberOfLightLayers(0)):
                ends = [0.0, 0.0]
                self.assertTrue(scene.shadows.GetLayerDepthRange(0, layer, ends))
                begin = ends[0]
                with self.subTest(distance=distance, layer=layer):
                    self.assertLess(abs(begin - distance), 8)


if __name__ == "__main__":
    unittest.main()
