# SPDX-License-Identifier: BSD-3-Clause
"""Shadows in chains of passes that are there before, that come later, and that are made anew."""

import gc
import sys
import unittest
import warnings

import rtwshadows
from stage import (
    add_pane,
    darker,
    make_renderer,
    make_window,
    picture,
    sequence,
)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkDefaultPass,
    vtkDepthOfFieldPass,
    vtkDepthPeelingPass,
    vtkDualDepthPeelingPass,
    vtkEDLShading,
    vtkGaussianBlurPass,
    vtkLightsPass,
    vtkOpaquePass,
    vtkOpenGLFXAAPass,
    vtkOrderIndependentTranslucentPass,
    vtkOverlayPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkShadowMapPass,
    vtkSimpleMotionBlurPass,
    vtkSSAAPass,
    vtkSSAOPass,
    vtkToneMappingPass,
    vtkTranslucentPass,
    vtkValuePass,
    vtkVolumetricPass,
)


def around(outer, inner):
    outer.SetDelegatePass(inner)
    return outer


def ssao(inner):
    result = around(vtkSSAOPass(), inner)
    result.SetRadius(0.5)
    result.SetKernelSize(32)
    return result


def motion_blur(inner):
    result = around(vtkSimpleMotionBlurPass(), inner)
    result.SetSubFrames(1)
    return result


def peeled(peeling):
    peeling.SetTranslucentPass(vtkTranslucentPass())
    return peeling


def camera(*passes):
    return around(vtkCameraPass(), sequence(*passes))


def steps():
    return vtkRenderStepsPass()


def steps_with(**which):
    result = steps()
    for name, one in which.items():
        getattr(result, "Set" + name)(one)
    return result


def vedo_ssao():
    """As vedo's add_ambient_occlusion() puts them together."""
    dual = peeled(vtkDualDepthPeelingPass())
    dual.SetVolumetricPass(vtkVolumetricPass())
    return camera(
        vtkLightsPass(), ssao(around(vtkCameraPass(), vtkOpaquePass())), dual, vtkOverlayPass())


CHAINS = {
    "steps": steps,
    "SSAO": lambda: ssao(steps()),
    "FXAA": lambda: around(vtkOpenGLFXAAPass(), steps()),
    "EDL": lambda: around(vtkEDLShading(), steps()),
    "tone mapping": lambda: around(vtkToneMappingPass(), steps()),
    "blur": lambda: around(vtkGaussianBlurPass(), steps()),
    "motion blur": lambda: motion_blur(steps()),
    "depth of field": lambda: around(vtkDepthOfFieldPass(), steps()),
    "SSAA": lambda: around(vtkSSAAPass(), steps()),
    "FXAA of SSAO": lambda: around(vtkOpenGLFXAAPass(), ssao(steps())),
    "camera, sequence, steps": lambda: camera(steps()),
    "classic": lambda: camera(vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass()),
    "classic, overlay": lambda: camera(
        vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass(), vtkVolumetricPass(),
        vtkOverlayPass()),
    "classic, opaque alone": lambda: camera(vtkLightsPass(), vtkOpaquePass()),
    "nested": lambda: camera(
        sequence(vtkLightsPass(), vtkOpaquePass()), sequence(vtkTranslucentPass())),
    "default": lambda: camera(vtkLightsPass(), vtkDefaultPass()),
    "peeling": lambda: camera(vtkLightsPass(), vtkOpaquePass(), peeled(vtkDepthPeelingPass())),
    "dual": lambda: camera(vtkLightsPass(), vtkOpaquePass(), peeled(vtkDualDepthPeelingPass())),
    "unordered": lambda: camera(
        vtkLightsPass(), vtkOpaquePass(), peeled(vtkOrderIndependentTranslucentPass())),
    "SSAO in steps": lambda: steps_with(
        OpaquePass=ssao(around(vtkCameraPass(), vtkOpaquePass()))),
    "steps, peeled": lambda: steps_with(TranslucentPass=peeled(vtkDualDepthPeelingPass())),
    "camera of SSAO": lambda: around(
        vtkCameraPass(), ssao(sequence(vtkLightsPass(), vtkOpaquePass()))),
    "vedo SSAO": vedo_ssao,
}


class PyVistaPasses:
    """An imitation of how PyVista's renderers manage passes, since it needn't be installed: the
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

    def update(self, camera_alone=False):
        current = self._camera
        for effect in self._effects:
            current = around(effect, current)
        self._renderer.SetPass(current if self._effects or camera_alone else None)


class Plotter:
    def __init__(self, renderer):
        self.renderer = renderer


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


class TestChains(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Where the shadow falls: from the same scene without any other pass."""
        cls.shadows = []
        for pane in (False, True):
            renderer = make_renderer()
            if pane:
                add_pane(renderer)
            window = make_window(renderer)
            without = picture(window)
            rtwshadows.enable_shadows(renderer)
            cls.shadows.append(darker(without, picture(window)))
        assert 0.01 < cls.shadows[0].mean() < 0.1 < 3 * cls.shadows[1].mean()

    def check_shadow(self, before, after, name, unlike=0.15, pane=False):
        """That what became darker is where the shadow is: edges may be smoothed or displaced."""
        shadow = self.shadows[pane]
        found = darker(before, after)
        wrong = (found != shadow).sum() / shadow.sum()
        self.assertLess(wrong, unlike, f"{name}: {wrong}")

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
                renderer.SetPass(None)

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
