# SPDX-License-Identifier: BSD-3-Clause
"""Shadows in chains of passes that are there before, and that come later."""

import gc
import sys
import unittest
import warnings

import rtwshadows
from chain_makers import CHAINS, ShadowCheck, around, camera, peeled, ssao, steps, steps_with
from stage import add_pane, make_renderer, make_window, picture
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkDualDepthPeelingPass,
    vtkGaussianBlurPass,
    vtkOpenGLFXAAPass,
    vtkSequencePass,
    vtkShadowMapPass,
    vtkValuePass,
)


def tree(one, depth=0):
    """A chain as classes, each pass with those that it holds."""
    if one is None:
        return None
    held = []
    for name in ("DelegatePass", "OpaquePass", "TranslucentPass", "VolumetricPass", "OverlayPass",
                 "LightsPass", "PostProcessPass"):
        if hasattr(one, "Get" + name):
            held.append((name, tree(getattr(one, "Get" + name)(), depth + 1)))
    if isinstance(one, vtkSequencePass):
        passes = one.GetPasses()
        held += [tree(passes.GetItemAsObject(i), depth + 1)
                 for i in range(passes.GetNumberOfItems())]
    return one.__this__, held


class TestChains(ShadowCheck):
    def test_shadows_come_and_go_in_every_chain(self):
        for name, make in CHAINS.items():
            with self.subTest(name):
                renderer = make_renderer()
                add_pane(renderer)
                window = make_window(renderer)
                chain = make()
                renderer.SetPass(chain)
                before = tree(chain)
                without = picture(window)
                rtwshadows.enable_shadows(renderer, resolution=512)
                gc.collect()
                self.check_shadow(without, picture(window), name, pane=True)
                rtwshadows.disable_shadows(renderer)
                self.assertIs(renderer.GetPass(), chain)
                self.assertEqual(tree(renderer.GetPass()), before, name)
                self.assertLessEqual(abs(picture(window) - without).max(), 0, name)

    def test_without_shadows_the_picture_stays(self):
        """Of a light whose shadows weigh nothing, and of one without: our steps draw what those
        that they stand for drew."""
        for name, make in CHAINS.items():
            with self.subTest(name):
                renderer = make_renderer()
                add_pane(renderer)
                renderer.GetLights().GetItemAsObject(0).SetShadowAttenuation(0)
                window = make_window(renderer)
                renderer.SetPass(make())
                without = picture(window)
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    rtwshadows.enable_shadows(renderer)
                self.assertLessEqual(abs(picture(window) - without).max(), 1, name)

    def test_what_is_around_stays(self):
        renderer = make_renderer()
        inner = ssao(steps())
        outer = around(vtkOpenGLFXAAPass(), inner)
        renderer.SetPass(outer)
        shadows = rtwshadows.enable_shadows(renderer)
        self.assertIs(renderer.GetPass(), outer)
        self.assertIs(outer.GetDelegatePass(), inner)
        self.assertIs(inner.GetDelegatePass().GetShadowMapPass(), shadows)

    def test_steps_are_taken_over(self):
        renderer = make_renderer()
        translucent = peeled(vtkDualDepthPeelingPass())
        theirs = steps_with(TranslucentPass=translucent, OverlayPass=None)
        renderer.SetPass(theirs)
        rtwshadows.enable_shadows(renderer)
        self.assertIs(renderer.GetPass().GetTranslucentPass(), translucent)
        self.assertIs(renderer.GetPass().GetOpaquePass(), theirs.GetOpaquePass())
        self.assertIsNone(renderer.GetPass().GetOverlayPass())

    def test_wrapped_later(self):
        """Whatever was there before, the pass around stays and has something to work on."""
        theirs = steps()
        for before in (None, theirs):
            renderer = make_renderer()
            renderer.SetPass(before)
            window = make_window(renderer)
            rtwshadows.enable_shadows(renderer)
            blur = around(vtkGaussianBlurPass(), renderer.GetPass())
            outer = camera(blur)
            renderer.SetPass(outer)
            with_shadows = picture(window)
            rtwshadows.disable_shadows(renderer)
            self.assertIs(renderer.GetPass(), outer)
            self.assertIs(outer.GetDelegatePass().GetPasses().GetItemAsObject(0), blur)
            inner = blur.GetDelegatePass()
            self.assertEqual(inner.GetClassName(), "vtkRenderStepsPass")
            if before is not None:
                self.assertIs(inner, before)
            self.check_shadow(picture(window), with_shadows, "wrapped")

    def test_wrapped_and_enabled_again(self):
        renderer = make_renderer()
        window = make_window(renderer)
        rtwshadows.enable_shadows(renderer)
        fxaa = around(vtkOpenGLFXAAPass(), renderer.GetPass())
        renderer.SetPass(fxaa)
        second = rtwshadows.enable_shadows(renderer, "uniform")
        self.assertIs(renderer.GetPass(), fxaa)
        self.assertIs(fxaa.GetDelegatePass().GetShadowMapPass(), second)
        with_shadows = picture(window)
        rtwshadows.disable_shadows(renderer)
        self.check_shadow(picture(window), with_shadows, "again")

    def test_unwrapped_later(self):
        renderer = make_renderer()
        theirs = steps()
        fxaa = around(vtkOpenGLFXAAPass(), theirs)
        renderer.SetPass(fxaa)
        rtwshadows.enable_shadows(renderer)
        renderer.SetPass(fxaa.GetDelegatePass())
        rtwshadows.disable_shadows(renderer)
        self.assertIs(renderer.GetPass(), theirs)
        self.assertIs(fxaa.GetDelegatePass(), theirs)

    def test_delegate_is_missing(self):
        renderer = make_renderer()
        window = make_window(renderer)
        without = picture(window)
        blur = vtkOpenGLFXAAPass()
        renderer.SetPass(blur)
        rtwshadows.enable_shadows(renderer)
        self.check_shadow(without, picture(window), "no delegate")
        rtwshadows.disable_shadows(renderer)
        self.assertIs(renderer.GetPass(), blur)
        self.assertIsNone(blur.GetDelegatePass())

    def test_vtk_shadows_are_left_out_meanwhile(self):
        for make in (lambda p: camera(p.GetShadowMapBakerPass(), p),
                     lambda p: camera(steps(), p.GetShadowMapBakerPass(), p)):
            renderer = make_renderer()
            window = make_window(renderer)
            without = picture(window)
            chain = make(vtkShadowMapPass())
            before = tree(chain)
            renderer.SetPass(chain)
            rtwshadows.enable_shadows(renderer)
            self.check_shadow(without, picture(window), "VTK's")
            rtwshadows.disable_shadows(renderer)
            self.assertEqual(tree(renderer.GetPass()), before)

    def test_what_shades_nothing_is_replaced(self):
        renderer = make_renderer()
        window = make_window(renderer)
        without = picture(window)
        values = vtkValuePass()
        renderer.SetPass(values)
        with self.assertWarnsRegex(UserWarning, "vtkValuePass draws the scene in a way"):
            rtwshadows.enable_shadows(renderer)
        self.check_shadow(without, picture(window), "values")
        rtwshadows.disable_shadows(renderer)
        self.assertIs(renderer.GetPass(), values)

    def test_a_renderer_is_its_users(self):
        renderer = make_renderer()
        window = make_window(renderer)
        without = picture(window)
        rtwshadows.enable_shadows(renderer)
        renderer.SetPass(None)
        self.assertLessEqual(abs(picture(window) - without).max(), 0)
        rtwshadows.disable_shadows(renderer)
        self.assertIsNone(renderer.GetPass())


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
