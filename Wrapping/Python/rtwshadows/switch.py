# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on and off, in one line."""

import warnings

from . import vtkRTWShadows as _module
from .chains import Graft
from .lights import AddedLight, casts_shadows, check_light, has_scene
from .properties import set_properties
from .targets import find_renderers
from .techniques import make_pass

# What is remembered of a renderer. VTK keeps a Python attribute as long as its object lives, and for
# some time after that, so it is emptied when the renderer goes.
_STATE = "_rtwshadows_state"


class _State:
    """What is known of one renderer whose shadows are on."""

    def __init__(self):
        self.graft = None
        self.light = None
        self.managed = False  # whether others put the chain together anew
        self.unfitted = False  # whether the light waits for a scene and a view to be fitted to
        self.observer = None
        self.end = None  # the observer of the renderer's end

    def clear(self):
        self.graft = self.light = None


def _state_of(renderer):
    return getattr(renderer, _STATE, None)


def _remember(renderer, state):
    # Not by setattr(), which subclasses in Python may refuse for names that are not theirs.
    object.__setattr__(renderer, _STATE, state)


def _release(render_pass, renderer):
    """Free what a pass has on the GPU, so that it may be left alone or dropped."""
    window = renderer.GetRenderWindow()
    if render_pass is not None and window is not None and not window.GetNeverRendered():
        window.MakeCurrent()
        render_pass.ReleaseGraphicsResources(window)


def _on_start(renderer, _event):
    """Called as a frame begins: fits the light, and gives a chain made anew its steps back."""
    state = _state_of(renderer)
    if state is None:
        return
    if state.unfitted:
        state.unfitted = False
        state.light.fit(renderer)
    if state.managed:
        state.graft.keep_in(renderer)


def _observe(renderer, state):
    """Let _on_start() be called, if there is anything for it to do."""
    if state.observer is not None:
        renderer.RemoveObserver(state.observer)
        state.observer = None
    if state.managed or state.unfitted:
        state.observer = renderer.AddObserver("StartEvent", _on_start)


def _has_drawn(renderer):
    """Whether there is a scene and a view of it, as far as can be told."""
    window = renderer.GetRenderWindow()
    return (window is not None and not window.GetNeverRendered()
            and renderer.IsActiveCameraCreated() and has_scene(renderer))


def _take_out(renderer, state):
    state.graft.remove(renderer)
    _release(state.graft.steps, renderer)


def _enable(renderer, managed, shadows, light):
    state = _state_of(renderer)
    if state is None:
        state = _State()
        _remember(renderer, state)
        state.end = renderer.AddObserver("DeleteEvent", lambda *_: state.clear())
    else:
        _take_out(renderer, state)
    steps = _module.vtkShadowRenderStepsPass()
    steps.SetShadowMapPass(shadows)
    state.graft = Graft(renderer, steps)
    _release(state.graft.left_out, renderer)
    state.managed = state.managed or managed
    if light is not None:
        if state.light is not None:
            state.light.remove(renderer)
        state.light = AddedLight(renderer, light)
        state.unfitted = not _has_drawn(renderer)
    _observe(renderer, state)


def _warn_of_lights(renderers):
    """Say once that there is nothing to see."""
    dark = [renderer for renderer in renderers if not casts_shadows(renderer)]
    if not dark:
        return
    which = "the renderer" if len(renderers) == 1 else f"{len(dark)} of {len(renderers)} renderers"
    warnings.warn(
        f"{which} has no light that casts a shadow which could be seen: a headlight, which VTK "
        "makes where there is no light, shines from the eye. Add a light: enable_shadows(..., "
        'light="sun"), or "lamp", "camera-left", a direction towards the light (3 numbers), or a '
        "vtkLight", stacklevel=3)


def enable_shadows(
        renderer_or_plotter, technique="rtw", resolution=1024, *, light=None, **properties):
    """Let the lights of a renderer cast shadows, and return the pass that draws them.

    renderer_or_plotter: a vtkRenderer; a vtkRenderWindow, for all its renderers that are drawn and
        interactive, which leaves out backgrounds and orientation axes; a plotter, for its
        .renderers (the subplots of PyVista and vedo) or its .renderer; or a list or tuple of any
        of these.
    technique: one of available_techniques().
    resolution: texels a side of a shadow map.
    light: a light to add, which disable_shadows() takes away again. None, the default, leaves the
        lights as they are, with one that was added before. A renderer that has no light, or only
        a headlight, shows no shadows without: that gives a warning.
        "sun": from the left, above and behind the viewer, as the camera stands now, and up is the
            axis next to the camera's view up; it stays where it is when the camera moves.
        "lamp": a spot from there, three radii of the scene away, whose cone covers what is
            visible.
        "camera-left": from the left above the camera, and moves along with it.
        a direction: three numbers in world coordinates that point from the scene towards the
            light, as the position of a vtkLight does whose focal point is the origin.
        a vtkLight: that one, as it is.
        Before a window's first frame, and where there is no scene yet, "sun", "lamp" and a
        direction are fitted once more when the next frame begins; enable shadows again to fit them
        to another scene. Lights that follow the camera, such as VTK's headlight, would wash shadows
        out: beside an added light their intensities are lowered to 0.3 in sum, until it is taken
        away. Where there is no other light at all, a headlight of 0.3 is added with it. Lights of
        the scene stay as they are. What is made by name or direction is white and has the intensity
        0.7.
    properties: what else is to be set on the pass, in either spelling, enumerators as words:
        focus_on_view=True, FocusOnView=True, filter="bilinear".

    Returns the pass; a list of passes, one a renderer, for several renderers and for every list.
    Each renderer has its own.

    A chain of passes that a renderer has is kept: our steps take the place of what draws the scene
    in it, at the inner end of SSAO, FXAA, EDL, blurs, tone mapping and their like. VTK's own
    shadows are left out meanwhile. Our steps may be wrapped later, or be moved: disable_shadows()
    finds them. A plotter that makes its chain anew, as PyVista does with each effect that is
    switched on or off, gets them back when its next frame begins; a vtkRenderer that is handed
    over as such draws whatever somebody sets as its pass.

    Enabling again replaces the shadows there are. Nothing is rendered: call Render() as usual.
    Raises TypeError for an object with no renderer, for an unknown property and a value of another
    type; ValueError for an unknown technique or light, and for a value that is refused or would
    be clamped. All renderers are then as they were.
    """
    light = check_light(light)
    renderers = find_renderers(renderer_or_plotter)
    passes = []
    for _ in renderers:
        passes.append(make_pass(technique))
        set_properties(passes[-1], {"resolution": resolution, **properties})
    for (renderer, managed), shadows in zip(renderers, passes):
        _enable(renderer, managed, shadows, light)
    _warn_of_lights([renderer for renderer, _ in renderers])
    several = len(passes) > 1 or isinstance(renderer_or_plotter, (list, tuple))
    return passes if several else passes[0]


def disable_shadows(renderer_or_plotter):
    """Undo enable_shadows: the renderers draw as they did, with the lights that they had.

    renderer_or_plotter: as for enable_shadows().

    Our steps are taken out of the chain of passes, wherever in it they are now, and what they took
    the place of comes back; all else in the chain stays as it is. A light that was added is
    removed, and lights that were dimmed for it are as bright as before, but for those that
    somebody else has changed since. Where shadows are not enabled nothing is done.
    """
    for renderer, _ in find_renderers(renderer_or_plotter, every=True):
        state = _state_of(renderer)
        if state is None:
            continue
        _remember(renderer, None)
        renderer.RemoveObserver(state.end)
        if state.observer is not None:
            renderer.RemoveObserver(state.observer)
        if state.light is not None:
            state.light.remove(renderer)
        _take_out(renderer, state)
