# SPDX-License-Identifier: BSD-3-Clause
"""Eyes and lamps far from what they see and light: shadows are those of a near view, and of the sun.

What is right is computed: a ball's shadow on a floor, ray by ray. Bounds are shares of the floor's
pixels; the near view has 0.05 % of them wrong or less, all at the shadow's edge, where a map's texel or
the ball's facets decide."""

import math
import unittest

import numpy as np
import rtwshadows
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

TECHNIQUES = "uniform", "rtw", "notw", "perspective", "cascades", "exact"
SIZE = 240, 180
SUN = np.array((3, 1, 4)) / math.sqrt(26)
DIRECTION = np.array((0.1, -0.7, 0.7)) / math.sqrt(0.99)
WRONG = 0.002  # of the floor's pixels: some ten at the edge


class Scene:
    """A floor, white or of that opacity, and a ball that is red all over."""

    def __init__(self, samples=0, opacity=1.0, mapper=False):
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(0, 0, 1)
        self.renderer.AutomaticLightCreationOff()
        self.window = vtk.vtkRenderWindow()
        self.window.SetMultiSamples(samples)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)
        floor = vtk.vtkPlaneSource()
        floor.SetOrigin(-5, -5, 0)
        floor.SetPoint1(5, -5, 0)
        floor.SetPoint2(-5, 5, 0)
        ball = vtk.vtkSphereSource()
        ball.SetCenter(0, 0, 1)
        ball.SetRadius(1)
        ball.SetThetaResolution(128)
        ball.SetPhiResolution(128)
        self.add(floor, (1, 1, 1), 1, opacity, mapper)
        self.add(ball, (1, 0, 0), 0, 1.0, mapper)
        self.light = vtk.vtkLight()
        self.light.SetPosition(*SUN)
        self.light.SetFocalPoint(0, 0, 0)
        self.renderer.AddLight(self.light)
        self.lamp = None
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetViewUp(0, 0, 1)
        self.shadows = None

    def add(self, source, color, lit, opacity, mapper):
        actor = vtk.vtkActor()
        actor.SetMapper(vtk.vtkPolyDataMapper())
        actor.GetMapper().SetInputConnection(source.GetOutputPort())
        if mapper:  # which cuts nothing, but only VTK's mapper knows
            plane = vtk.vtkPlane()
            plane.SetOrigin(0, 0, -100)
            plane.SetNormal(0, 0, 1)
            actor.GetMapper().AddClippingPlane(plane)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetAmbient(1 - lit)
        actor.GetProperty().SetDiffuse(lit)
        actor.GetProperty().SetOpacity(opacity)
        self.renderer.AddActor(actor)

    def look(self, distance, parallel=True, angle=30.0, clipping=None):
        self.camera.SetPosition(*(DIRECTION * distance))
        self.camera.SetParallelProjection(parallel)
        self.camera.SetParallelScale(4)
        self.camera.SetViewAngle(angle)
        self.renderer.ResetCameraClippingRange()
        if clipping:
            self.camera.SetClippingRange(*clipping)

    def shine(self, distance):
        """From a spot at the sun's place, whose cone holds the floor."""
        self.lamp = SUN * distance
        self.light.SetPosition(*self.lamp)
        self.light.PositionalOn()
        self.light.SetConeAngle(math.degrees(math.atan(9 / distance)))

    def use(self, technique, **settings):
        self.shadows = rtwshadows.enable_shadows(self.renderer, technique, **settings)

    def draw(self):
        self.window.Render()
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        scalars = grab.GetOutput().GetPointData().GetScalars()
        return vtk_to_numpy(scalars).reshape(SIZE[1], SIZE[0], -1).astype(int)

    def mask(self):
        image = self.shadows.GetShadowMask(0)
        scalars = vtk_to_numpy(image.GetPointData().GetScalars())
        return scalars.reshape(SIZE[1], SIZE[0]).astype(int)

    def floor(self):
        """Where the rays of the pixels meet the floor's plane. In double precision, from where the
        view looks, because an eye that is far away leaves few digits."""
        width, height = SIZE
        x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1, (np.arange(height) + 0.5) / height * 2 - 1)
        forward = -DIRECTION
        right = np.cross(forward, (0, 0, 1))
        right /= np.linalg.norm(right)
        up = np.cross(right, forward)
        distance = self.camera.GetDistance()
        parallel = self.camera.GetParallelProjection()
        half = 4 if parallel else distance * math.tan(math.radians(self.camera.GetViewAngle() / 2))
        at = (x * half * width / height)[..., None] * right + (y * half)[..., None] * up
        along = forward if parallel else at / distance + forward
        return at - at[..., 2:] / (along + 0 * at)[..., 2:] * along

    def wrong(self, by_mask=False):
        picture = self.draw()
        at = self.floor()
        to = SUN if self.lamp is None else self.lamp - at
        to = to / np.linalg.norm(to, axis=-1, keepdims=True)
        ball = (0, 0, 1) - at
        along = (ball * to).sum(-1)
        shadowed = (along > 0) & ((ball * ball).sum(-1) - along**2 < 1)
        high, floor = picture.max(-1), (np.ptp(picture, -1) < 40) & (abs(at[..., :2]).max(-1) < 4.9)
        assert shadowed[floor].mean() > 0.02
        if by_mask:
            assert (self.mask() != 128)[floor].mean() > 0.999
            return ((self.mask() < 128) != shadowed)[floor].mean()
        white = np.percentile(high[floor], 90)
        assert white > 60
        return ((high < 0.5 * white) != shadowed)[floor].mean()


VIEWS = {
    "near": dict(distance=20),
    "among": dict(distance=3),
    "1e3": dict(distance=1e3),
    "1e5": dict(distance=1e5),
    "1e7": dict(distance=1e7),
    "behind the near plane": dict(distance=20, clipping=(-500, 500)),
    "wide range": dict(distance=1e4, clipping=(1, 1e6)),
    "perspective": dict(distance=20, parallel=False, angle=22.0),
    "perspective, wide range": dict(distance=20, parallel=False, angle=22.0, clipping=(0.1, 1e7)),
    "telephoto": dict(distance=2000, parallel=False, angle=0.2),
    "longer telephoto": dict(distance=2e4, parallel=False, angle=0.02),
    "longest telephoto": dict(distance=1e6, parallel=False, angle=0.0004),
}
FAR = "near", "1e5", "telephoto", "wide range"


class TestFar(unittest.TestCase):
    def check(self, scene, views, techniques=TECHNIQUES, bound=WRONG, **settings):
        for technique in techniques:
            scene.use(technique, **settings)
            for name in views:
                scene.look(**VIEWS[name])
                wrong = scene.wrong()
                with self.subTest(technique=technique, view=name):
                    self.assertLessEqual(wrong, bound)

    def test_eyes(self):
        self.check(Scene(), VIEWS)

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

    def test_spots(self):
        """A spot that is far away is as the sun. The mask is looked at, because VTK's own lighting
        doesn't find what lies in so narrow a cone."""
        for technique in TECHNIQUES:
            for distance in (51, 510, 5100, 1e5, 1e7):
                scene = Scene()
                scene.use(technique)
                scene.look(20)
                scene.shine(distance)
                wrong = scene.wrong(by_mask=True)
                with self.subTest(technique=technique, distance=distance):
                    self.assertLessEqual(wrong, WRONG)

    def test_far_eye_and_spot(self):
        scene = Scene()
        scene.shine(5100)
        self.check(scene, ("1e5", "telephoto"))

    def test_mappers(self):
        """What only VTK's mappers draw."""
        self.check(Scene(mapper=True), FAR, bound=0.004)

    def test_translucent(self):
        """Receivers that look maps up themselves, by VTK's view coordinates or by depth."""
        self.check(Scene(opacity=0.99), ("near", "1e5", "telephoto", "perspective"), bound=0.004)

    def test_samples(self):
        """Several samples a pixel: edges are grey there, and nothing else is wrong."""
        self.check(Scene(samples=4), FAR, bound=0.008)

    def test_previous_frame(self):
        for technique in ("rtw", "cascades", "perspective"):
            scene = Scene()
            scene.use(technique, view_sample_source="previous_frame")
            for name in FAR:
                scene.look(**VIEWS[name])
                scene.draw()
                wrong = scene.wrong()
                with self.subTest(technique=technique, view=name):
                    self.assertLessEqual(wrong, 0.006)

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
