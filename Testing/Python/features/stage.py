# SPDX-License-Identifier: BSD-3-Clause
"""A window with a scene of casters and receivers, and how it is photographed."""

import os

os.environ.pop("DISPLAY", None)
os.environ.pop("WAYLAND_DISPLAY", None)

import rtwshadows  # noqa: E402,F401 - makes VTK's window a headless one
import vtkmodules.all as vtk  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402

ROWS = {}


def row(function):
    """A feature: a function that puts it into a stage."""
    ROWS[function.__name__] = function
    return function


def make(name, **settings):
    """A VTK object with its properties: make("vtkActor", Mapper=mapper)."""
    thing = getattr(vtk, name)()
    for key, value in settings.items():
        getattr(thing, "Set" + key)(*(value if isinstance(value, tuple) else (value,)))
    return thing


def fed(algorithm, source, port=0):
    """An algorithm, of whose input a source is; an output port alone keeps no source alive."""
    algorithm.SetInputConnection(port, source.GetOutputPort())
    return algorithm


def mapper_of(source, **settings):
    return fed(make("vtkPolyDataMapper", **settings), source)


def actor_of(source, colour=(1, 1, 1), **settings):
    """An actor of a source; settings are those of its property."""
    looks = make("vtkProperty", Color=colour, Ambient=0.15, **settings)
    return make("vtkActor", Mapper=mapper_of(source), Property=looks)


def ball(centre=(0, 0, 0), radius=1.0, n=24):
    return make("vtkSphereSource", Center=centre, Radius=radius, ThetaResolution=n,
                PhiResolution=n)


def box(centre, size):
    return make("vtkCubeSource", Center=centre, XLength=size[0], YLength=size[1], ZLength=size[2])


def floor(half=4, z=0.0):
    return make("vtkPlaneSource", Origin=(-half, -half, z), Point1=(half, -half, z),
                Point2=(-half, half, z))


def pixels_of(window, **settings):
    """The window's pixels as they are now: rows, columns, channels."""
    settings = {"ReadFrontBuffer": False, "ShouldRerender": False, **settings}
    grab = make("vtkWindowToImageFilter", Input=window, **settings)
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).copy()


class Stage:
    """A floor under a ball, a box and a pole that stands before their shadows, and a sun.

    window, renderer: what there is at the beginning.
    shadowed: the renderers that get our passes.
    chain: makes the pass that a renderer is given of the steps; None where it is the steps alone,
        and, to compare with, no pass at all.
    photograph: returns arrays, by name; a row may replace it.
    """

    def __init__(self):
        self.renderer = make("vtkRenderer", Background=(0.1, 0.2, 0.4),
                             AutomaticLightCreation=False)
        self.window = make("vtkRenderWindow", MultiSamples=0, Size=(160, 120))
        self.window.AddRenderer(self.renderer)
        self.shadowed = [self.renderer]
        self.chain = None
        self.photograph = self.photograph_window
        self.kept = []
        self.floor = self.add(floor(), (0.9, 0.9, 0.8))
        self.ball = self.add(ball((0.5, 0, 1.2)), (0.9, 0.4, 0.3))
        self.box = self.add(box((-1.8, 0.6, 1), (1, 1, 2)), (0.4, 0.8, 0.4))
        self.pole = self.add(box((-0.9, -2.4, 0.9), (0.2, 0.2, 1.8)), (0.4, 0.5, 0.9))
        self.sun = make("vtkLight", Position=(3, -2, 5), FocalPoint=(0, 0, 0))
        self.renderer.AddLight(self.sun)
        self.aim(self.renderer)

    @staticmethod
    def aim(renderer, shift=(0, 0, 0)):
        x, y, z = shift
        camera = renderer.GetActiveCamera()
        camera.SetPosition(x - 1.5, y - 7.5, z + 5)
        camera.SetFocalPoint(x, y, z + 0.4)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCameraClippingRange()

    def add(self, source, colour=(1, 1, 1), **settings):
        actor = actor_of(source, colour, **settings)
        self.renderer.AddActor(actor)
        return actor

    def copy_of(self):
        """Another renderer, with the same props and the same sun.

        It looks the same way, since VTK may leave a shader the light's direction as the other camera sees it.
        """
        other = make("vtkRenderer", AutomaticLightCreation=False)
        for prop in (self.floor, self.ball, self.box, self.pole):
            other.AddActor(prop)
        other.AddLight(self.sun)
        self.aim(other, (1, 1, 0))
        return other

    def lights(self):
        found = {}
        for renderer in self.shadowed:
            collection = renderer.GetLights()
            for i in range(collection.GetNumberOfItems()):
                light = collection.GetItemAsObject(i)
                found[light] = light
        return list(found.values())

    def set_attenuation(self, attenuation):
        for light in self.lights():
            light.SetShadowAttenuation(attenuation)

    @staticmethod
    def give(renderer, render_pass):
        """VTK's passes want what they have on the GPU to be released before they go."""
        old, window = renderer.GetPass(), renderer.GetRenderWindow()
        if old and not window.GetNeverRendered():
            window.MakeCurrent()
            old.ReleaseGraphicsResources(window)
        renderer.SetPass(render_pass)

    def without_shadows(self):
        for renderer in self.shadowed:
            self.give(renderer, self.chain(vtk.vtkRenderStepsPass()) if self.chain else None)

    def with_shadows(self, technique):
        """Returns the shadow map passes, one a renderer. "steps" is VTK's steps alone, to compare with."""
        passes = []
        for renderer in self.shadowed:
            steps = vtk.vtkRenderStepsPass()
            if technique != "steps":
                shadows = rtwshadows.techniques.make_pass(technique)
                shadows.SetResolution(128)
                steps = rtwshadows.vtkShadowRenderStepsPass()
                steps.SetShadowMapPass(shadows)
                passes.append(shadows)
            self.give(renderer, self.chain(steps) if self.chain else steps)
        return passes

    def photograph_window(self):
        self.window.Render()
        return self.read_window()

    def read_window(self):
        colours = pixels_of(self.window, InputBufferType=vtk.VTK_RGBA)
        depths = pixels_of(self.window, InputBufferType=vtk.VTK_ZBUFFER)
        return {"colour": colours, "depth": depths}

    def finish(self):
        """Gives back what the window has, in an order that VTK bears."""
        for renderer in self.shadowed:
            self.give(renderer, None)
        for window in [self.window, *self.kept]:
            if isinstance(window, vtk.vtkRenderWindow):
                window.Finalize()
