# SPDX-License-Identifier: BSD-3-Clause
"""The renderers that are meant by what somebody hands over."""

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow


def _is_scene(renderer):
    """Neither a background nor an orientation widget's renderer, nor one that isn't drawn."""
    return bool(renderer.GetDraw() and renderer.GetInteractive())


def _of_window(window):
    collection = window.GetRenderers()
    return [collection.GetItemAsObject(i) for i in range(collection.GetNumberOfItems())]


def _of_plotter(plotter):
    """By .renderers (PyVista's and vedo's subplots), else .renderer; None where it has neither."""
    try:
        several = list(getattr(plotter, "renderers", None) or ())
    except TypeError:
        several = []
    several = [one for one in several if isinstance(one, vtkRenderer)]
    if several:
        return several
    renderer = getattr(plotter, "renderer", None)
    return [renderer] if isinstance(renderer, vtkRenderer) else None


def _manages_passes(renderer):
    """PyVista's renderers put their passes together anew with each effect that comes or goes."""
    return hasattr(renderer, "_render_passes")


def _collect(target, every):
    if isinstance(target, vtkRenderer):
        return [(target, _manages_passes(target))]
    if isinstance(target, vtkRenderWindow):
        return [(one, _manages_passes(one)) for one in _of_window(target)
                if every or _is_scene(one)]
    if isinstance(target, (list, tuple)):
        return [pair for one in target for pair in _collect(one, every)]
    renderers = _of_plotter(target)
    if renderers is None:
        raise TypeError(
            "expected a vtkRenderer, a vtkRenderWindow, an object that has renderers as "
            ".renderers or one as .renderer, or a list of those, "
            f"not {type(target).__name__}"
        )
    return [(one, True) for one in renderers]


def find_renderers(target, every=False):
    """The renderers of a target, each once: pairs of a renderer and whether others manage its
    passes, as plotters do.

    every: also those of a window that draw no scene.
    Raises TypeError for what has no renderers, ValueError for what might but has none now.
    """
    found = []
    for renderer, managed in _collect(target, every):
        known = [i for i, (other, _) in enumerate(found) if other is renderer]
        if known:
            found[known[0]] = (renderer, managed or found[known[0]][1])
        else:
            found.append((renderer, managed))
    if not found and not every:
        raise ValueError(
            f"{type(target).__name__} has no renderer that draws a scene: add one first")
    return found
