# SPDX-License-Identifier: BSD-3-Clause
"""Lights that cast shadows, for renderers that have none."""

import math
import numbers

from vtkmodules.vtkCommonCore import vtkMath
from vtkmodules.vtkRenderingCore import vtkLight

LIGHTS = ("sun", "lamp", "camera-left")

# In sum VTK's headlight of 1: nothing burns out that didn't under it. A shadow is about a third as
# bright as what is around it.
_FILL = 0.3
_INTENSITY = 0.7

# From what is looked at towards the light, to the right, up and back to the eye.
_TOWARDS_SUN = (-0.6, 1.0, 0.4)
_TOWARDS_LAMP = (-0.5, 1.2, 0.4)
_TOWARDS_CAMERA_LEFT = (-0.6, 0.7, 1.0)

# A lamp stands so many radii of the scene from its centre: nearer ones need a cone wider than
# what casts shadows, farther ones are suns.
_LAMP_DISTANCE = 3.0


def lights_of(renderer):
    """The lights of a renderer that are on."""
    lights = renderer.GetLights()
    every = [lights.GetItemAsObject(i) for i in range(lights.GetNumberOfItems())]
    return [light for light in every if light.GetSwitch()]


def _follows_camera(light):
    return bool(light.LightTypeIsHeadlight() or light.LightTypeIsCameraLight())


def casts_shadows(renderer):
    """Whether any light of a renderer may cast a shadow that can be seen.

    A headlight shines from the eye, so that its shadows can't be. Lights that shine and cast
    nothing for another reason are named by the pass itself, when it draws.
    """
    return any(not light.LightTypeIsHeadlight() and light.GetIntensity() > 0
               and light.GetShadowAttenuation() > 0 for light in lights_of(renderer))


def _direction(numbers_given):
    towards = [float(number) for number in numbers_given]
    length = math.sqrt(sum(number * number for number in towards))
    if len(towards) != 3 or not math.isfinite(length) or length == 0:
        raise ValueError(
            f"light={numbers_given!r} is refused: a direction towards the light is three finite "
            "numbers, not all 0")
    return [number / length for number in towards]


def check_light(light):
    """What enable_shadows takes as a light, made uniform: a vtkLight, a name, or three numbers of
    length 1. TypeError or ValueError for anything else."""
    if light is None or isinstance(light, vtkLight):
        return light
    if isinstance(light, str):
        name = light.replace("_", "-").lower()
        if name not in LIGHTS:
            raise ValueError(
                f"light={light!r} is not known; among: {', '.join(map(repr, LIGHTS))}, "
                "a direction towards the light (3 numbers), or a vtkLight")
        return name
    try:
        items = list(light)
    except TypeError:
        items = []
    if not items or not all(isinstance(item, numbers.Real) for item in items):
        raise TypeError(
            f"light={light!r}: expected one of {', '.join(map(repr, LIGHTS))}, a direction "
            "towards the light (3 numbers), or a vtkLight")
    return _direction(items)


def _cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _unit(vector):
    length = math.sqrt(sum(x * x for x in vector))
    return [x / length for x in vector] if length > 1e-9 else None


def _view_axes(renderer):
    """Right, up and back to the eye of a level view: up is the scene's axis that is nearest to the
    camera's."""
    if not renderer.IsActiveCameraCreated():
        return (1, 0, 0), (0, 1, 0), (0, 0, 1)
    camera = renderer.GetActiveCamera()
    view_up = camera.GetViewUp()
    axis = max(range(3), key=lambda k: abs(view_up[k]))
    up = [math.copysign(1.0, view_up[k]) if k == axis else 0.0 for k in range(3)]
    along = camera.GetDirectionOfProjection()
    right = _unit(_cross(along, up)) or _unit(_cross(up, [up[2], up[0], up[1]]))
    return right, up, _cross(right, up)


def has_scene(renderer):
    """Whether anything is visible."""
    return bool(vtkMath.AreBoundsInitialized(renderer.ComputeVisiblePropBounds()))


def _sphere(renderer):
    """Centre and radius of what is visible, in world units; the origin and 1 where nothing is."""
    bounds = renderer.ComputeVisiblePropBounds()
    if not vtkMath.AreBoundsInitialized(bounds):
        return (0.0, 0.0, 0.0), 1.0
    centre = [(bounds[2 * k] + bounds[2 * k + 1]) / 2 for k in range(3)]
    radius = math.sqrt(sum((bounds[2 * k + 1] - bounds[2 * k]) ** 2 for k in range(3))) / 2
    return centre, radius if radius > 0 else 1.0


def _stand(light, renderer, towards, radii):
    """Place a light so many radii of the scene away from its centre, and let it look there."""
    centre, radius = _sphere(renderer)
    light.SetLightTypeToSceneLight()
    light.SetFocalPoint(centre)
    light.SetPosition([c + t * radii * radius for c, t in zip(centre, towards)])


def _in_world(axes, shares):
    return _unit([sum(share * axis[k] for share, axis in zip(shares, axes)) for k in range(3)])


def _place(light, renderer, wanted):
    """Set a light of ours up as it was asked for, by the scene and the view as they are now."""
    if wanted == "camera-left":
        light.SetLightTypeToCameraLight()
        light.SetPosition(_TOWARDS_CAMERA_LEFT)
        light.SetFocalPoint(0, 0, 0)
    elif wanted == "lamp":
        light.PositionalOn()
        light.SetConeAngle(math.degrees(math.asin(1 / _LAMP_DISTANCE)) * 1.1)
        light.SetExponent(0)
        _stand(light, renderer, _in_world(_view_axes(renderer), _TOWARDS_LAMP), _LAMP_DISTANCE)
    elif wanted == "sun":
        _stand(light, renderer, _in_world(_view_axes(renderer), _TOWARDS_SUN), 2.0)
    else:
        _stand(light, renderer, wanted, 2.0)


class AddedLight:
    """A light that was added to a renderer, and what was done to the others for its sake."""

    def __init__(self, renderer, wanted):
        self._wanted = wanted
        self._given = isinstance(wanted, vtkLight)
        self._light = wanted if self._given else vtkLight()
        self._added = []
        self._dimmed = []
        if not self._given:
            self._light.SetIntensity(_INTENSITY)
        self._put(renderer)

    def fit(self, renderer):
        """Put it where it belongs in the scene, and beside the lights, as they are now."""
        self.remove(renderer)
        self._put(renderer)

    def _put(self, renderer):
        others = [one for one in lights_of(renderer) if one is not self._light]
        if not self._given:
            _place(self._light, renderer, self._wanted)
        self._dim([one for one in others if _follows_camera(one)])
        if not others:
            # VTK makes its headlight only where there is no light at all.
            fill = vtkLight()
            fill.SetLightTypeToHeadlight()
            fill.SetIntensity(_FILL)
            self._add(renderer, fill)
        self._add(renderer, self._light)

    def _add(self, renderer, light):
        if not renderer.GetLights().IsItemPresent(light):
            renderer.AddLight(light)
            self._added.append(light)

    def _dim(self, lights):
        total = sum(max(light.GetIntensity(), 0) for light in lights)
        if total <= _FILL:
            return
        for light in lights:
            before = light.GetIntensity()
            light.SetIntensity(before * _FILL / total)
            self._dimmed.append((light, before, light.GetIntensity()))

    def remove(self, renderer):
        """Take it away, and give the others their intensity, where nobody else has changed it."""
        for light in self._added:
            renderer.RemoveLight(light)
        for light, before, dimmed in self._dimmed:
            if light.GetIntensity() == dimmed:
                light.SetIntensity(before)
        self._added = []
        self._dimmed = []
