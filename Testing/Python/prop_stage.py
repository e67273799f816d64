# SPDX-License-Identifier: BSD-3-Clause
"""A stage on which one prop after another is drawn, with and without shadows.

A sun, a white floor, and a red slab whose shadow falls on the floor behind the prop, as the viewer sees
it; so what is darkened by the mask of what lies behind it is seen to be. A roof, out of sight, can be
put above the prop: what receives is dark below it.
"""

from pictures import grab

import rtwshadows
import vtkmodules.all as vtk

CENTRE = (0, -3.7, 0.8)  # of the prop
HALF = 0.7
SUN = (2, 2, 3)
SIZE = (160, 120)


def make(name, **settings):
    thing = getattr(vtk, name)()
    for key, value in settings.items():
        getattr(thing, "Set" + key)(*(value if isinstance(value, tuple) else (value,)))
    return thing


def box(centre=CENTRE, half=(HALF, HALF, HALF)):
    bounds = [c + sign * h for c, h in zip(centre, half) for sign in (-1, 1)]
    source = make("vtkCubeSource", Bounds=tuple(bounds))
    source.Update()
    return source.GetOutput()


def actor_of(data, kind="vtkActor", mapper="vtkPolyDataMapper", **settings):
    actor = make(kind, Mapper=make(mapper, InputDataObject=data), **settings)
    actor.GetProperty().SetColor(0, 1, 0)
    return actor


class Stage:
    def __init__(self, technique):
        self.renderer = make("vtkRenderer", Background=(0, 0, 1), AutomaticLightCreation=False)
        self.window = make("vtkRenderWindow", MultiSamples=0, Size=SIZE)
        self.window.AddRenderer(self.renderer)
        self.interactor = make("vtkRenderWindowInteractor", RenderWindow=self.window)
        self.light = make("vtkLight", Position=SUN, FocalPoint=(0, 0, 0))
        self.renderer.AddLight(self.light)
        floor = make("vtkPlaneSource", Origin=(-10, -10, 0), Point1=(10, -10, 0), Point2=(-10, 10, 0))
        floor.Update()
        self._add(floor.GetOutput(), (1, 1, 1), 0)
        self._add(box((1.5, 1.5, 4.1), (4.5, 1.5, 0.1)), (1, 0, 0), 1)
        self.roof = self._add(
            box([c + 3 * s for c, s in zip(CENTRE, SUN)], (2, 2, 0.05)), (1, 0, 0), 1)
        self.roof.VisibilityOff()
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -9, 7)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCameraClippingRange()
        rtwshadows.enable_shadows(self.renderer, technique)
        self.shadowed = self.renderer.GetPass()
        self.shadowless = rtwshadows.vtkShadowRenderStepsPass()  # the same steps, none of ours among them
        self.shadowless.SetShadowMapPass(None)
        self.bare = self.shoot()
        self.renderer.SetPass(self.shadowless)
        self.bare_shadowless = self.shoot()

    def _add(self, data, colour, ambient):
        actor = actor_of(data)
        actor.SetProperty(make("vtkProperty", Color=colour, Ambient=ambient, Diffuse=1 - ambient))
        self.renderer.AddActor(actor)
        return actor

    def shoot(self):
        self.window.Render()
        return grab(self.window)

    def look(self, prop):
        """What shadows do to a prop and it to them; see Seen."""
        self.renderer.AddViewProp(prop)
        self.renderer.SetPass(self.shadowless)
        self.shoot()  # some props are complete in their second frame only
        plain = self.shoot()
        self.renderer.SetPass(self.shadowed)
        picture = self.shoot()
        self.roof.VisibilityOn()
        below = self.shoot()
        self.roof.VisibilityOff()
        self.light.SetShadowAttenuation(1e-4)  # 0 would skip the light
        unshadowed = self.shoot()
        self.light.SetShadowAttenuation(1)
        self.renderer.RemoveViewProp(prop)
        return Seen(self, plain, picture, below, unshadowed)


class Seen:
    """pixels: that show the prop. darkened: the share of them that is dark in the sun. casts: pixels of its
    shadow, on the rest of the picture. receives: the share of its pixels that the roof darkens. holes: pixels of
    it that show the background. changed: the largest difference, of 255, that our passes make where shadows take
    no light away."""

    def __init__(self, stage, plain, picture, below, unshadowed):
        its = (abs(plain - stage.bare_shadowless) > 30).any(-1)
        high = picture.max(-1)
        self.pixels = int(its.sum())
        share = max(self.pixels, 1)
        self.darkened = ((high < plain.max(-1) - 12) & its).sum() / share
        self.casts = int(((high < stage.bare.max(-1) - 60) & ~its).sum())
        self.receives = ((below.max(-1) < high - 12) & its).sum() / share
        self.changed = int(abs(unshadowed - plain).max())
        blue = [seen[..., 2] > seen[..., :2].max(-1) + 60 for seen in (picture, plain)]
        self.holes = int((blue[0] & ~blue[1] & its).sum())
