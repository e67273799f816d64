# SPDX-License-Identifier: BSD-3-Clause
"""A small scene for tests of the package: a ball above a floor, a pane before it, a sun."""

from pictures import grab

from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkRenderPassCollection,
    vtkSequencePass,
)


def plane(origin, first, second):
    source = vtkPlaneSource()
    source.SetOrigin(origin)
    source.SetPoint1(first)
    source.SetPoint2(second)
    return source


def ball(centre, radius, resolution=24):
    source = vtkSphereSource()
    source.SetCenter(centre)
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return source


def add_actor(renderer, source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


def add_sun(renderer):
    light = vtkLight()
    light.SetPosition(3, 0, 3)
    light.SetFocalPoint(0, 0, 0)
    renderer.AddLight(light)
    return light


def make_renderer(sun=True, look=True):
    """A ball over a floor; z is up."""
    renderer = vtkRenderer()
    add_actor(renderer, plane((-3, -3, 0), (3, -3, 0), (-3, 3, 0)))
    add_actor(renderer, ball((0, 0, 1), 0.5))
    if sun:
        renderer.AutomaticLightCreationOff()
        add_sun(renderer)
    if look:
        camera = renderer.GetActiveCamera()
        camera.SetPosition(0, -8, 8)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCameraClippingRange()
    return renderer


def add_pane(renderer):
    """A translucent pane over a corner of the floor."""
    pane = add_actor(renderer, plane((-2.8, -2.8, 0.4), (-1, -2.8, 0.4), (-2.8, -1, 0.4)))
    pane.GetProperty().SetOpacity(0.5)
    pane.GetProperty().SetColor(1, 0.2, 0.2)


def make_window(*renderers, size=(160, 120)):
    window = vtkRenderWindow()
    window.SetSize(*size)
    window.SetMultiSamples(0)
    for renderer in renderers:
        window.AddRenderer(renderer)
    return window


def picture(window):
    """Rows of pixels, from the bottom, of three integers."""
    window.Render()
    return grab(window)


def darker(before, after):
    """Which pixels lost half of a channel."""
    return (before - after > before / 2 + 4).any(axis=2)


def sequence(*passes):
    collection = vtkRenderPassCollection()
    for one in passes:
        collection.AddItem(one)
    result = vtkSequencePass()
    result.SetPasses(collection)
    return result
