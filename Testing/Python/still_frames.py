# SPDX-License-Identifier: BSD-3-Clause
"""A stage whose still frames draw no layers, and what the tests of those ask of it."""

import unittest

from pictures import grab

import rtwshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)


class Stage:
    def __init__(self, technique, **settings):
        vtkMapper.SetResolveCoincidentTopologyToOff()  # as a stage before may have left it
        self.kept = []  # an output port keeps no algorithm
        self.renderer = vtkRenderer()
        self.light = vtkLight()
        self.light.SetPosition(2, 1, 5)
        self.light.SetFocalPoint(0, 0, 0)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(self.light)
        self.window = vtkRenderWindow()
        self.window.SetSize(160, 120)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetPosition(0, -9, 8)
        self.camera.SetFocalPoint(0, 0, 0.5)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetClippingRange(3, 30)
        self.shadows = rtwshadows.enable_shadows(self.renderer, technique, 256, **settings)
        self.add(self.surface(self.square(4, 0)))

    def add(self, mapper, kind=vtkActor):
        actor = kind()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def surface(self, source, mapper=vtkPolyDataMapper):
        self.kept.append(source)
        mapper = mapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.ScalarVisibilityOff()
        return mapper

    def square(self, size, z):
        square = vtkPlaneSource()
        square.SetOrigin(-size, -size, z)
        square.SetPoint1(size, -size, z)
        square.SetPoint2(-size, size, z)
        return square

    def ball(self, radius=1.0):
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        ball.SetCenter(0, 0, 1.5)
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(24)
        self.kept.append(ball)
        return ball

    def clipped(self, mapper=vtkPolyDataMapper, source=None):
        mapper = self.surface(source or self.ball(), mapper)
        plane = vtkPlane()
        plane.SetOrigin(0, 0, 1.5)
        plane.SetNormal(1, 0, 0)
        mapper.AddClippingPlane(plane)
        return mapper, plane, self.add(mapper)

    def render(self):
        self.window.Render()
        return self.shadows.GetNumberOfLayersDrawn()

    def picture(self):
        return grab(self.window).reshape(-1, 3)


def write(array, change):
    """Returns what changes an array in place, and only it is told."""
    def run():
        change(vtk_to_numpy(array))
        array.Modified()
    return run


def stretch(values):
    values[:] *= (1.4, 1.4, 1)


class StillFrames(unittest.TestCase):
    """Of each scene in SCENES: a function that adds to a stage, and returns what changes something in it."""

    SCENES = ()

    def check(self, scene, technique):
        stage = Stage(technique)
        change = scene(stage)
        for _ in range(3):  # vtkDataSetMapper makes its surface in the first
            drawn = stage.render()
        before = stage.picture()
        self.assertEqual(drawn, 0, "in a still frame")
        change()
        stage.render()
        changed = stage.picture()
        for _ in range(2):  # drawing hands some changes on to what the mapper holds
            drawn = stage.render()
        self.assertEqual(drawn, 0, "in a still frame after the change")
        # What is right: the frame that is drawn without a look at what changed.
        stage.shadows.CachingOff()
        stage.render()
        right = stage.picture()

        def differing(a, b):
            return int((abs(a - b).max(axis=1) > 8).sum())

        self.assertGreater(differing(before, right), 50, "the change is not seen")
        self.assertLessEqual(differing(changed, right), 3)

    def test_changes(self):
        for technique in ("rtw", "exact"):
            for scene in self.SCENES:
                with self.subTest(technique=technique, change=scene.__name__):
                    self.check(scene, technique)

    def test_still_frames_that_look_at_the_last(self):
        for scene in self.SCENES:
            with self.subTest(scene=scene.__name__):
                stage = Stage("rtw", view_sample_source="previous_frame")
                scene(stage)
                self.assertEqual([stage.render() for _ in range(4)][3:], [0])
