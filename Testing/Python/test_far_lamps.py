# SPDX-License-Identifier: BSD-3-Clause
"""Spots far from what they light: shadows are those of the sun."""

import unittest

from far_scene import TECHNIQUES, WRONG, Scene, check


class TestFarLamps(unittest.TestCase):
    def test_spots(self):
        """A spot that is far away is as the sun. The mask is looked at, because VTK's own lighting
        doesn't find what lies in so narrow a cone."""
        scene = Scene()
        for technique in TECHNIQUES:
            scene.use(technique)
            scene.look(20)
            for distance in (51, 510, 5100, 1e5, 1e7):
                scene.shine(distance)
                wrong = scene.wrong(by_mask=True)
                with self.subTest(technique=technique, distance=distance):
                    self.assertLessEqual(wrong, WRONG)

    def test_far_eye_and_spot(self):
        scene = Scene()
        scene.shine(5100)
        check(self, scene, ("1e5", "telephoto"))


if __name__ == "__main__":
    unittest.main()
