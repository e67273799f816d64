# SPDX-License-Identifier: BSD-3-Clause
"""Each eye of a stereo pair shows what a camera at its place shows."""

import math
import sys
import unittest

from ball_on_floor import TECHNIQUES, Stage, differing, rtwshadows

SIZE = (160, 120)
TYPES = {  # as vtkRenderWindow numbers them
    "crystal eyes": 1,
    "red and blue": 2,
    "interlaced": 3,
    "left": 4,
    "right": 5,
    "dresden": 6,
    "anaglyph": 7,
    "checkerboard": 8,
    "split viewport": 9,
    "fake": 10,
    "emulate": 11,
}


class Eyes(Stage):
    """Takes down what each eye is drawn, and how many layers for it."""

    def __init__(self, technique, **kinds):
        super().__init__(SIZE, **kinds)
        self.shadows = technique and rtwshadows.enable_shadows(self.renderer, technique, 512)
        self.eyes = []
        self.renderer.AddObserver("EndEvent", self._note)

    def _note(self, *_):
        layers = (self.shadows.GetNumberOfLayersDrawn(), self.shadows.GetNumberOfLayersReused()) \
            if self.shadows else None
        self.eyes.append((self.camera.GetLeftEye(), self.drawn(), layers))

    def render(self, kind=None):
        self.eyes = []
        if kind is not None:
            self.window.StereoRenderOn()
            self.window.SetStereoType(kind)
        self.window.Render()
        return self.eyes

    def stand_at(self, left):
        """A camera without stereo where that eye is: moved sideways, and turned back to the focal
        plane by moving the window's centre, since stereo in VTK shears."""
        k = math.tan(math.radians(self.camera.GetEyeAngle() / 2)) * (1 if left else -1)
        aside = -k * self.camera.GetDistance()
        right = (1, 0, 0)  # as the stage's camera stands
        for get, put in ((self.camera.GetPosition, self.camera.SetPosition),
                         (self.camera.GetFocalPoint, self.camera.SetFocalPoint)):
            put(*(c + aside * r for c, r in zip(get(), right)))
        slope = math.tan(math.radians(self.camera.GetViewAngle() / 2)) * SIZE[0] / SIZE[1]
        self.camera.SetWindowCenter(k / slope, 0)


def mono(technique, left):
    stage = Eyes(technique)
    stage.stand_at(left)
    stage.render()
    return stage.eyes[0][1]


class TestStereo(unittest.TestCase):
    def test_vtk_itself_shows_what_such_cameras_show(self):
        """The measure of the others."""
        pair = Eyes(None).render(TYPES["red and blue"])
        for left, picture, _ in pair:
            self.assertLessEqual(differing(picture, mono(None, left), 2), 4)

    def test_every_technique_shows_each_eye_its_own(self):
        for technique in TECHNIQUES:
            pair = Eyes(technique).render(TYPES["anaglyph"])
            self.assertEqual([eye[0] for eye in pair], [1, 0])
            self.assertGreater(differing(pair[0][1], pair[1][1], 30), 100, technique)
            for left, picture, _ in pair:
                # A pixel at the shadow's edge may fall to either side.
                self.assertLess(differing(picture, mono(technique, left), 30), 40, technique)

    def test_every_kind(self):
        right = {eye: mono("exact", eye) for eye in (1, 0)}
        for name, kind in TYPES.items():
            stage = Eyes("exact")
            stage.window.StereoCapableWindowOn()
            pair = stage.render(kind)
            drawn = {"left": [1], "right": [0], "fake": [1, 1]}.get(name, [1, 0])
            self.assertEqual([eye[0] for eye in pair], drawn, name)
            for left, picture, _ in pair:
                self.assertLess(differing(picture, right[left], 30), 20, name)

    def test_a_still_pair_draws_nothing_again(self):
        for technique in TECHNIQUES:
            stage = Eyes(technique)
            for _ in range(4):
                first = stage.render(TYPES["anaglyph"])
            builds = stage.shadows.GetShaderStageMTime()
            again = stage.render()
            for (_, before, _), (_, after, (drawn, reused)) in zip(first, again):
                self.assertEqual(drawn, 0, technique)
                self.assertGreater(reused, 0, technique)
                self.assertTrue((before == after).all(), technique)
            self.assertEqual(stage.shadows.GetShaderStageMTime(), builds, technique)
            stage.camera.Azimuth(2)
            for _, _, (drawn, _) in stage.render():
                self.assertGreater(drawn, 0, technique)

    def test_one_eye_only_stands_still_too(self):
        for kind in ("left", "right"):
            stage = Eyes("uniform")
            stage.render(TYPES[kind])
            stage.render()
            self.assertEqual([eye[2][0] for eye in stage.eyes], [0], kind)

    def test_switched_on_and_off(self):
        for technique in ("rtw", "exact"):
            stage = Eyes(technique)
            flat = stage.render()[0][1]
            memory = stage.shadows.GetShadowMemory()
            for _ in range(3):
                pair = stage.render(TYPES["dresden"])
                self.assertGreater(differing(pair[0][1], pair[1][1], 30), 100)
                self.assertLessEqual(stage.shadows.GetShadowMemory(), 2.1 * memory)
                stage.window.StereoRenderOff()
                self.assertLess(differing(stage.render()[0][1], flat), 10)
                self.assertLessEqual(stage.shadows.GetShadowMemory(), 1.05 * memory)

    def test_a_window_made_anew(self):
        stage = Eyes("exact")
        first = stage.render(TYPES["anaglyph"])
        stage.window.Finalize()
        again = stage.render(TYPES["anaglyph"])
        for (_, before, _), (_, after, _) in zip(first, again):
            self.assertLess(differing(before, after), 10)
        rtwshadows.disable_shadows(stage.renderer)

    def test_the_classic_chain(self):
        stage = Eyes(None)
        stage.shadows = rtwshadows.vtkExactShadowMapPass()
        stage.set_classic_chain(stage.shadows)
        for left, picture, _ in stage.render(TYPES["anaglyph"]):
            self.assertLess(differing(picture, mono("exact", left), 30), 20)

    def test_sheared_parallel_views(self):
        """A shear of a parallel view, as stereo has, leaves the shadow where it is on the floor."""
        for shear in (0.0, 0.4):
            stage = Stage(SIZE)
            stage.camera.SetPosition(0, 0, 20)
            stage.camera.SetViewUp(0, 1, 0)
            stage.camera.ParallelProjectionOn()
            stage.camera.SetParallelScale(4)
            stage.camera.SetViewShear(shear, 0, 1)
            stage.renderer.ResetCameraClippingRange()
            stage.ball.SetVisibility(True)
            without = stage.picture()
            rtwshadows.enable_shadows(stage.renderer, "exact")
            dark = (without - stage.picture()).max(axis=2) > 60
            floor = dark[:, :SIZE[0] // 2]  # the lamp is on the right
            self.assertGreater(int(floor.sum()), 150)
            if shear == 0:
                straight = floor
            else:
                # Only the ball itself, which hides other parts of its shadow, has moved.
                moved = int((straight & ~floor).sum() + (floor & ~straight).sum())
                self.assertLess(moved, 0.35 * int(straight.sum()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
