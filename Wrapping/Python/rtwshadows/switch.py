# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on and off, in one line."""

from vtkmodules.vtkRenderingCore import vtkRenderer

from . import vtkRTWShadows as _module
from .properties import set_properties
from .techniques import make_pass

# What our render steps remember of the time before them. VTK keeps a Python attribute as long as
# its object lives, so there is nothing to clean up here.
_PREVIOUS = "_rtwshadows_previous_pass"


def _get_renderer(renderer_or_plotter):
    if isinstance(renderer_or_plotter, vtkRenderer):
        return renderer_or_plotter
    renderer = getattr(renderer_or_plotter, "renderer", None)
    if isinstance(renderer, vtkRenderer):
        return renderer
    raise TypeError(
        "expected a vtkRenderer, or an object that has one as .renderer, "
        f"not {type(renderer_or_plotter).__name__}"
    )


def _release(render_pass, renderer):
    """Free what a pass has on the GPU, so that it may be left alone or dropped."""
    window = renderer.GetRenderWindow()
    if render_pass is not None and window is not None and not window.GetNeverRendered():
        window.MakeCurrent()
        render_pass.ReleaseGraphicsResources(window)


def enable_shadows(renderer_or_plotter, technique="rtw", resolution=1024, **properties):
    """Let the lights of a renderer cast shadows, and return the pass that draws them.

    renderer_or_plotter: a vtkRenderer, or an object that has one as .renderer (PyVista, vedo).
    technique: one of available_techniques().
    resolution: texels a side of a shadow map.
    properties: what else is to be set on the pass, in either spelling, enumerators as words:
        focus_on_view=True, FocusOnView=True, filter="bilinear".

    Enabling again replaces the shadows there are. Nothing is rendered: call Render() as usual.
    Raises TypeError for an object with no renderer and for an unknown property, ValueError for an
    unknown technique; the renderer is then as it was.
    """
    renderer = _get_renderer(renderer_or_plotter)
    shadows = make_pass(technique)
    set_properties(shadows, {"resolution": resolution, **properties})

    current = renderer.GetPass()
    _release(current, renderer)
    previous = getattr(current, _PREVIOUS) if hasattr(current, _PREVIOUS) else current
    steps = _module.vtkShadowRenderStepsPass()
    steps.SetShadowMapPass(shadows)
    setattr(steps, _PREVIOUS, previous)
    renderer.SetPass(steps)
    return shadows


def disable_shadows(renderer_or_plotter):
    """Undo enable_shadows: the renderer gets back the pass it had, or none.

    Where shadows were not enabled, or the pass has been changed since, nothing is done.
    """
    renderer = _get_renderer(renderer_or_plotter)
    current = renderer.GetPass()
    if not hasattr(current, _PREVIOUS):
        return
    _release(current, renderer)
    renderer.SetPass(getattr(current, _PREVIOUS))
