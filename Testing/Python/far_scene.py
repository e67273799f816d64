# SPDX-License-Identifier: BSD-3-Clause
"""A ball's shadow on a floor, seen and lit from near and far: what is right is computed, ray by ray.

Bounds are shares of the floor's pixels. A near view has 0.02 % of them wrong, all at the shadow's edge,
where a map's texel or the ball's facets decide."""

import math

from pictures import grab

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
        return grab(self.window)

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


def check(test, scene, views, techniques=TECHNIQUES, bound=WRONG, **settings):
    for technique in techniques:
        scene.use(technique, **settings)
        for name in views:
            scene.look(**VIEWS[name])
            wrong = scene.wrong()
            with test.subTest(technique=technique, view=name):
                test.assertLessEqual(wrong, bound)
