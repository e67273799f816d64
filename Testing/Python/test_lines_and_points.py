# SPDX-License-Identifier: BSD-3-Clause
"""Lines and points that are drawn some pixels wide cast the shadows of rods and balls as wide as that."""

import math
import unittest

from pictures import grab

import rtwshadows
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import (
    vtkLineSource,
    vtkPlaneSource,
    vtkPointSource,
    vtkSphereSource,
)
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

TECHNIQUES = ("uniform", "rtw", "notw", "perspective", "cascades", "exact")
WIDTH = 20
SIZE = (250, 200)


class Stage:
    """A line and a point over a floor, of so many pixels, or a real tube and ball of that size."""

    def __init__(self, unit=1.0, real=False, round_=True, lit=False, spot=False, parallel=False,
                 samples=0, width=WIDTH, toward=(0, 1, 1)):
        self.unit = unit
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.SetBackground(0, 0, 1)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(samples)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -9 * unit, 9 * unit)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetParallelProjection(parallel)
        camera.SetParallelScale(4 * unit)
        light = vtkLight()
        light.SetFocalPoint(0, 0, 0)
        light.SetPosition(*(8 * unit * x for x in toward))
        light.SetPositional(spot)
        light.SetConeAngle(50)
        self.renderer.AddLight(light)
        floor = vtkPlaneSource()
        floor.SetOrigin(-5 * unit, -5 * unit, 0)
        floor.SetPoint1(5 * unit, -5 * unit, 0)
        floor.SetPoint2(-5 * unit, 5 * unit, 0)
        self.add(floor, (1, 1, 1), True)
        for source in self.real(width) if real else self.drawn():
            look = self.add(source, (1, 0, 0), lit).GetProperty()
            look.SetLineWidth(width)
            look.SetPointSize(width)
            look.SetRenderLinesAsTubes(round_)
            look.SetRenderPointsAsSpheres(round_)
        self.renderer.ResetCameraClippingRange()

    def add(self, source, color, lit):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetAmbient(not lit)
        actor.GetProperty().SetDiffuse(lit)
        self.renderer.AddActor(actor)
        return actor

    def place(self, x):
        return [c * self.unit for c in (x, 1, 2)]

    def drawn(self):
        line = vtkLineSource()
        line.SetPoint1(self.place(-3))
        line.SetPoint2(self.place(1))
        point = vtkPointSource()
        point.SetCenter(self.place(3))
        point.SetRadius(0)
        point.SetNumberOfPoints(1)
        return line, point

    def real(self, width):
        camera = self.renderer.GetActiveCamera()
        forward, eye = camera.GetDirectionOfProjection(), camera.GetPosition()
        distance = sum(f * (p - e) for f, p, e in zip(forward, self.place(0), eye))
        half = (camera.GetParallelScale() if camera.GetParallelProjection() else
                distance * math.tan(math.radians(camera.GetViewAngle() / 2)))
        radius = width * half / SIZE[1]
        line = self.drawn()[0]
        line.Update()
        tube = vtkTubeFilter()
        tube.SetInputData(line.GetOutput())
        tube.SetRadius(radius)
        tube.SetNumberOfSides(64)
        tube.CappingOn()
        ball = vtkSphereSource()
        ball.SetCenter(self.place(3))
        ball.SetRadius(radius)
        ball.SetThetaResolution(64)
        ball.SetPhiResolution(64)
        return tube, ball

    def shoot(self, technique=None, resolution=1024):
        if technique:
            rtwshadows.enable_shadows(self.renderer, technique, resolution=resolution)
        self.window.Render()
        return grab(self.window)


def shadow(picture):
    return picture.max(-1) < 60


def widths(flags):
    """Of the line and of the point: the most that a column of pixels holds."""
    column = flags.sum(0)
    return int(column[60:135].max()), int(column[200:235].max())


class LinesAndPoints(unittest.TestCase):
    def assert_as_real(self, stage, real, technique, share, resolution=1024):
        """No more of the real thing's shadow is otherwise than a share of it."""
        drawn, exact = stage.shoot(technique, resolution), real
        thing = (drawn[..., 0] - drawn[..., 1] > 60) | (exact[..., 0] - exact[..., 1] > 60)
        wrong = ((shadow(drawn) != shadow(exact)) & ~thing).sum()
        self.assertLess(wrong, share * (shadow(exact) & ~thing).sum())

    def test_as_wide_as_real_ones(self):
        """A tube of the radius that the pixels stand for casts the right shadow, exactly."""
        for looks in ({}, {"spot": True}, {"parallel": True}, {"samples": 4}):
            real = Stage(real=True, **looks).shoot("exact")
            few = "parallel" in looks or "samples" in looks
            for technique in ("rtw", "exact") if few else TECHNIQUES:
                with self.subTest(technique=technique, **looks):
                    # Maps are off by a texel at either side.
                    share = 0.01 if technique == "exact" else 0.1
                    self.assert_as_real(Stage(**looks), real, technique, share)

    def test_any_unit(self):
        for unit in (1e-6, 1e-3, 1e6):
            for round_ in (True, False):
                for technique in ("rtw", "exact"):
                    with self.subTest(unit=unit, round=round_, technique=technique):
                        picture = Stage(unit, round_=round_).shoot(technique)
                        for width in widths(shadow(picture)):
                            self.assertGreater(width, WIDTH / 1.2)
                            self.assertLess(width, WIDTH * 1.2)

    def test_any_resolution(self):
        real = Stage(real=True).shoot("exact")
        for technique in ("uniform", "rtw"):
            for resolution in (256, 4096):
                with self.subTest(technique=technique, resolution=resolution):
                    # A texel of 256 a side is four pixels here.
                    share = 0.25 if resolution == 256 else 0.05
                    self.assert_as_real(Stage(), real, technique, share, resolution)

    def test_thin_line(self):
        """Of one pixel: so is its shadow, without a gap."""
        for round_ in (True, False):
            picture = Stage(width=1, round_=round_).shoot("exact")
            column = shadow(picture).sum(0)[70:130]
            self.assertGreaterEqual(column.min(), 1)
            self.assertLessEqual(column.max(), 2)

    def test_no_shadow_on_itself(self):
        """What a tube and a ball show of light, alone, they show with shadows too."""
        for looks in ({}, {"spot": True}, {"parallel": True}, {"samples": 4}):
            for toward in ((0, -1, 1), (1, -0.3, 1)):
                plain = Stage(lit=True, toward=toward, **looks).shoot()
                lit = plain[..., 0] - plain[..., 1] > 25
                self.assertGreater(lit.sum(), 1000)
                for technique in ("rtw", "exact"):
                    with self.subTest(technique=technique, toward=toward, **looks):
                        picture = Stage(lit=True, toward=toward, **looks).shoot(technique)
                        dark = picture[..., 0] < 0.7 * plain[..., 0]
                        self.assertLess((dark & lit).sum(), 0.01 * lit.sum())

    def test_representations(self):
        """Points and edges of a surface cast, the wider the more, also in a still view."""
        for technique in ("rtw", "exact"):
            stage = Stage(real=True)
            looks = [stage.renderer.GetActors().GetItemAsObject(i).GetProperty() for i in (1, 2)]
            solid = shadow(stage.shoot(technique)).sum()
            for shape in ("Points", "Wireframe"):
                areas = []
                for width in (1, 2):
                    for look in looks:
                        getattr(look, f"SetRepresentationTo{shape}")()
                        look.SetPointSize(width)
                        look.SetLineWidth(width)
                    areas.append(shadow(stage.shoot()).sum())
                with self.subTest(technique=technique, shape=shape):
                    self.assertGreater(areas[0], 0.1 * solid)
                    self.assertGreater(areas[1], 1.05 * areas[0])
                    self.assertLess(areas[1], 1.15 * solid)


if __name__ == "__main__":
    unittest.main()
