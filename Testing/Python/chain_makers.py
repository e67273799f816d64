# SPDX-License-Identifier: BSD-3-Clause
"""Chains of VTK's passes, by name, and whether shadows fall where they should in one."""

import unittest

import rtwshadows
from stage import add_pane, darker, make_renderer, make_window, picture, sequence
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
    vtkRenderStepsPass,
    vtkSimpleMotionBlurPass,
    vtkSSAAPass,
    vtkSSAOPass,
    vtkToneMappingPass,
    vtkTranslucentPass,
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


class ShadowCheck(unittest.TestCase):
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
