# SPDX-License-Identifier: BSD-3-Clause
"""What shadows are switched on and off for: renderers, windows, plotters, and lists of them."""

import gc
import sys
import unittest

import rtwshadows
from rtwshadows import vtkAdaptiveShadowMapPass, vtkShadowRenderStepsPass
from stage import darker, make_renderer, make_window, picture
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow


class Plotter:
    """As PyVista's and vedo's with subplots: the current renderer, and all."""

    def __init__(self, renderers):
        self.renderer = renderers[0]
        self.renderers = renderers


class Renderers:
    """As PyVista's: no list, but it can be iterated."""

    def __init__(self, renderers):
        self._renderers = renderers

    def __iter__(self):
        yield from self._renderers


class Strict(vtkRenderer):
    """A subclass that takes no attributes but its own, as some of PyVista's classes."""

    def __setattr__(self, name, value):
        raise AttributeError(name)


def has_shadows(renderer):
    return isinstance(renderer.GetPass(), vtkShadowRenderStepsPass)


def second_picture(window):
    """VTK 9.1 lights the first of two renderers wrongly in a frame in which programs are new, with
    no pass at all too."""
    picture(window)
    return picture(window)


class TestTargets(unittest.TestCase):
    def check(self, target, expected, others=()):
        passes = rtwshadows.enable_shadows(target, "uniform", 64)
        self.assertIsInstance(passes, list)
        self.assertEqual(len(passes), len(expected))
        for one, renderer in zip(passes, expected):
            self.assertIsInstance(one, vtkAdaptiveShadowMapPass)
            self.assertIs(renderer.GetPass().GetShadowMapPass(), one)
        self.assertEqual(len({one.__this__ for one in passes}), len(passes))
        for renderer in others:
            self.assertIsNone(renderer.GetPass())
        rtwshadows.disable_shadows(target)
        for renderer in expected:
            self.assertIsNone(renderer.GetPass())

    def test_one_gives_a_pass(self):
        renderer = make_renderer()
        for target in (renderer, make_window(renderer), Plotter([renderer]),
                       type("Single", (), {"renderer": renderer})()):
            shadows = rtwshadows.enable_shadows(target)
            self.assertIsInstance(shadows, vtkAdaptiveShadowMapPass)
            self.assertIs(renderer.GetPass().GetShadowMapPass(), shadows)
            rtwshadows.disable_shadows(target)
            self.assertIsNone(renderer.GetPass())

    def test_window(self):
        """Without what is drawn behind, above or not at all."""
        first, second = make_renderer(), make_renderer()
        background, marker, hidden = vtkRenderer(), vtkRenderer(), vtkRenderer()
        background.InteractiveOff()
        marker.InteractiveOff()
        hidden.DrawOff()
        window = make_window(background, first, second, marker, hidden)
        self.check(window, [first, second], [background, marker, hidden])
        rtwshadows.enable_shadows([window, marker], light="sun")
        self.assertTrue(has_shadows(marker))
        second.InteractiveOff()  # since
        rtwshadows.disable_shadows(window)
        for renderer in (first, second, marker):
            self.assertIsNone(renderer.GetPass())

    def test_plotters(self):
        renderers = [make_renderer(), make_renderer(), make_renderer()]
        self.check(Plotter(renderers), renderers)
        plotter = Plotter(renderers)
        plotter.renderers = Renderers(renderers)
        self.check(plotter, renderers)

    def test_lists(self):
        a, b, c, d = (make_renderer() for _ in range(4))
        window = make_window(c)
        self.check([a], [a])
        self.check((a, b), [a, b])
        self.check([a, [Plotter([b, c])], window, (a, d)], [a, b, c, d])

    def test_each_has_its_own_shadows(self):
        """Two views of the scene in one window, one with another technique."""
        renderers = [make_renderer(), make_renderer()]
        for i, renderer in enumerate(renderers):
            renderer.SetViewport(i / 2, 0, (i + 1) / 2, 1)
        renderers[1].GetActiveCamera().Azimuth(40)
        renderers[1].ResetCameraClippingRange()
        window = make_window(*renderers, size=(320, 120))
        without = second_picture(window)
        rtwshadows.enable_shadows(window)
        dark = darker(without, second_picture(window))
        for half in (dark[:, :160], dark[:, 160:]):
            self.assertTrue(0.005 < half.mean() < 0.1, half.mean())
        rtwshadows.enable_shadows(renderers[1], "uniform", 512)
        second = darker(without, second_picture(window))
        self.assertTrue((second[:, :160] == dark[:, :160]).all())
        self.assertLess((second != dark).sum(), 0.2 * dark.sum())
        rtwshadows.disable_shadows(renderers[0])
        second = darker(without, second_picture(window))
        self.assertFalse(second[:, :160].any())
        self.assertTrue(second[:, 160:].any())
        rtwshadows.disable_shadows(window)
        self.assertTrue((second_picture(window) == without).all())

    def test_a_subclass_that_takes_no_attributes(self):
        renderer = Strict()
        rtwshadows.enable_shadows(renderer, light="sun")
        self.assertTrue(has_shadows(renderer))
        rtwshadows.disable_shadows(renderer)
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(renderer.GetLights().GetNumberOfItems(), 0)

    def test_remembered_without_a_reference(self):
        """In Python nobody need hold on to a renderer while its shadows are on."""
        window = make_window(make_renderer(sun=False))
        rtwshadows.enable_shadows(window, light="sun")
        for _ in range(3):
            gc.collect()
            picture(window)
        rtwshadows.disable_shadows(window)
        renderer = window.GetRenderers().GetFirstRenderer()
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(renderer.GetLights().GetNumberOfItems(), 0)

    def test_gone_with_its_renderer(self):
        """Shadows that nobody has switched off go with what they are of."""
        for target in (lambda renderer: renderer, lambda renderer: Plotter([renderer])):
            gone = []
            renderer = make_renderer(sun=False)
            window = make_window(renderer)
            shadows = rtwshadows.enable_shadows(target(renderer), light="lamp")
            picture(window)
            for one in (renderer, shadows):
                one.AddObserver("DeleteEvent", lambda *_: gone.append(1))
            del one, renderer, shadows, window
            gc.collect()
            self.assertEqual(len(gone), 2)

    def test_refused(self):
        renderer = make_renderer()
        for target in (None, 3, "renderer", [renderer, None], type("No", (), {})(),
                       type("Odd", (), {"renderer": 3, "renderers": 4})()):
            for call in (rtwshadows.enable_shadows, rtwshadows.disable_shadows):
                with self.assertRaisesRegex(TypeError, "vtkRenderer.*vtkRenderWindow.*, not "):
                    call(target)
        for target in ([], vtkRenderWindow()):
            with self.assertRaisesRegex(ValueError, "no renderer"):
                rtwshadows.enable_shadows(target)
            rtwshadows.disable_shadows(target)
        self.assertIsNone(renderer.GetPass())

    def test_all_or_none(self):
        """Where one can't have them no other gets them."""
        renderers = [make_renderer(), make_renderer()]
        with self.assertRaises(ValueError):
            rtwshadows.enable_shadows(renderers, filter_radius=-1)
        for renderer in renderers:
            self.assertIsNone(renderer.GetPass())


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
