# SPDX-License-Identifier: BSD-3-Clause
"""Shadows in chains of passes that others put together, and make anew while shadows are on."""

import gc
import sys
import unittest

import rtwshadows
from chain_makers import ShadowCheck, around
from stage import make_renderer, make_window, picture
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkGaussianBlurPass,
    vtkOpenGLFXAAPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
)


class PyVistaPasses:
    """An imitation of how PyVista's renderers manage passes, since it isn't installed here: the
    chain is made anew with each effect that comes or goes, from the effects and one camera pass
    around a collection, which stay; without effects there is no pass."""

    def __init__(self, renderer):
        self._renderer = renderer
        self.collection = vtkRenderPassCollection()
        self.collection.AddItem(vtkRenderStepsPass())
        inner = vtkSequencePass()
        inner.SetPasses(self.collection)
        self._camera = around(vtkCameraPass(), inner)
        self._effects = []

    def add(self, effect):
        self._effects.append(effect)
        self.update()

    def remove(self, effect):
        self._effects.remove(effect)
        self.update()
        effect.ReleaseGraphicsResources(self._renderer.GetRenderWindow())

    def update(self):
        current = self._camera
        for effect in self._effects:
            current = around(effect, current)
        self._renderer.SetPass(current if self._effects else None)


class Plotter:
    def __init__(self, renderer):
        self.renderer = renderer


class TestChainsAnew(ShadowCheck):
    def test_chains_that_are_made_anew(self):
        """In PyVista's way, through a plotter: effects come and go, shadows stay."""
        renderer = make_renderer()
        window = make_window(renderer)
        without = picture(window)
        passes = PyVistaPasses(renderer)
        inner = passes.collection.GetItemAsObject(0)
        plotter = Plotter(renderer)
        fxaa, blur = vtkOpenGLFXAAPass(), vtkGaussianBlurPass()
        shadows = rtwshadows.enable_shadows(plotter)
        changes = (lambda: passes.add(fxaa), lambda: passes.add(blur),
                   lambda: passes.remove(fxaa), lambda: passes.remove(blur),
                   lambda: passes.add(blur))
        for number, change in enumerate(changes):
            change()
            gc.collect()
            self.check_shadow(without, picture(window), f"change {number}", 0.3)
        self.assertEqual(shadows.GetNumberOfShadowLights(), 1)
        self.assertIs(renderer.GetPass(), blur)
        rtwshadows.disable_shadows(plotter)
        self.assertIs(renderer.GetPass(), blur)
        self.assertEqual(passes.collection.GetNumberOfItems(), 1)
        self.assertIs(passes.collection.GetItemAsObject(0), inner)
        passes.remove(blur)
        self.assertLessEqual(abs(picture(window) - without).max(), 0)
        self.assertIsNone(renderer.GetPass())

    def test_renderers_that_make_their_chains(self):
        """As PyVista's do, by themselves, whatever they are handed over in."""
        renderer = make_renderer()
        renderer._render_passes = PyVistaPasses(renderer)
        window = make_window(renderer)
        without = picture(window)
        for target in (renderer, window, [renderer]):
            rtwshadows.enable_shadows(target)
            fxaa = vtkOpenGLFXAAPass()
            renderer._render_passes.add(fxaa)
            self.check_shadow(without, picture(window), type(target).__name__)
            renderer._render_passes.remove(fxaa)
            self.check_shadow(without, picture(window), type(target).__name__)
            rtwshadows.disable_shadows(target)
            self.assertIsNone(renderer.GetPass())
            self.assertLessEqual(abs(picture(window) - without).max(), 0)

    def test_a_collection_that_others_keep(self):
        """Enabled while there is an effect, our steps are in the collection, which is put back
        however the chain ends."""
        renderer = make_renderer()
        window = make_window(renderer)
        without = picture(window)
        passes = PyVistaPasses(renderer)
        inner = passes.collection.GetItemAsObject(0)
        fxaa = vtkOpenGLFXAAPass()
        passes.add(fxaa)
        rtwshadows.enable_shadows(Plotter(renderer))
        self.assertIsNot(passes.collection.GetItemAsObject(0), inner)
        self.check_shadow(without, picture(window), "in it")
        passes.remove(fxaa)
        self.check_shadow(without, picture(window), "out of it")
        rtwshadows.disable_shadows(renderer)
        self.assertIsNone(renderer.GetPass())
        self.assertIs(passes.collection.GetItemAsObject(0), inner)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
