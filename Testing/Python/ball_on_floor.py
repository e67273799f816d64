# SPDX-License-Identifier: BSD-3-Clause
"""A ball above a floor under one lamp, for tests that compare pictures."""

from pictures import grab

import rtwshadows
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkRenderPassCollection,
    vtkSequencePass,
)

TECHNIQUES = rtwshadows.available_techniques()


class Stage:
    def __init__(self, size=(160, 120), samples=0, attenuation=1.0):
        self.renderer = vtkRenderer()
        floor = vtkPlaneSource()
        floor.SetOrigin(-3, -3, 0)
        floor.SetPoint1(3, -3, 0)
        floor.SetPoint2(-3, 3, 0)
        floor.SetResolution(8, 8)
        self.floor = self.add(floor)
        self.ball = self.add_ball(0, 0, 1, 0.5)
        self.ball.GetProperty().SetColor(1, 0.6, 0.2)
        self.light = vtkLight()
        self.light.SetPosition(3, 0, 3)
        self.light.SetFocalPoint(0, 0, 0)
        self.light.SetShadowAttenuation(attenuation)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(self.light)
        self.window = vtkRenderWindow()
        self.window.SetSize(*size)
        self.window.SetMultiSamples(samples)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetPosition(0, -8, 8)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCameraClippingRange()

    def add(self, source):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def add_ball(self, x, y, z, radius):
        ball = vtkSphereSource()
        ball.SetCenter(x, y, z)
        ball.SetRadius(radius)
        ball.SetThetaResolution(20)
        ball.SetPhiResolution(20)
        return self.add(ball)

    def set_classic_chain(self, shadows):
        passes = vtkRenderPassCollection()
        passes.AddItem(shadows.GetShadowMapBakerPass())
        passes.AddItem(shadows)
        sequence = vtkSequencePass()
        sequence.SetPasses(passes)
        camera = vtkCameraPass()
        camera.SetDelegatePass(sequence)
        self.renderer.SetPass(camera)

    def drawn(self):
        """What the window shows now, from below to above."""
        return grab(self.window)

    def picture(self):
        self.window.Render()
        return self.drawn()


def differing(a, b, by=1):
    """How many pixels differ by more than that."""
    return int((abs(a - b).max(axis=2) > by).sum())
