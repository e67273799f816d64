# SPDX-License-Identifier: BSD-3-Clause
"""What a renderer asks for by its flags it gets with our steps as without a pass. An attenuation of 0.00001 has all of the
shadows drawn and none of them seen, not even by a threshold of FXAA that the least step of a colour would cross."""

import itertools
import sys
import unittest

from ball_on_floor import TECHNIQUES, Stage, differing, rtwshadows
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkVolume
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

SIZE = (80, 60)


def fxaa(renderer):
    renderer.UseFXAAOn()


def fxaa_with_options(renderer):
    renderer.UseFXAAOn()
    options = renderer.GetFXAAOptions()
    options.SetSubpixelBlendLimit(0.1)
    options.SetRelativeContrastThreshold(0.5)
    options.SetEndpointSearchIterations(3)


def ssao(renderer):
    renderer.UseSSAOOn()
    renderer.SetSSAORadius(1.0)
    renderer.SetSSAOBias(0.05)


def ssao_with_settings(renderer):
    renderer.UseSSAOOn()
    renderer.SetSSAORadius(0.6)
    renderer.SetSSAOBias(0.01)
    renderer.SetSSAOKernelSize(64)
    renderer.SSAOBlurOn()


def hidden_lines(renderer):
    renderer.UseHiddenLineRemovalOn()


def peeling(renderer):
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(8)


def peeled_volumes(renderer):
    peeling(renderer)
    renderer.UseDepthPeelingForVolumesOn()


def in_order(renderer):
    if hasattr(renderer, "SetUseOIT"):
        renderer.UseOITOff()


FLAGS = (fxaa, fxaa_with_options, ssao, ssao_with_settings, hidden_lines, peeling, peeled_volumes, in_order)


class Scene(Stage):
    """With what each flag is for: glass behind glass, a volume, a wireframe before a face."""

    def __init__(self, flags=(), attenuation=1e-5, samples=0, glass=True, wireframe=False, volume=False):
        super().__init__(SIZE, samples, attenuation)
        for x, y in ((-1.5, 0.5), (-1.3, -0.6)) if glass else ():
            ball = self.add_ball(x, y, 1, 0.6)
            ball.GetProperty().SetOpacity(0.4)
            ball.GetProperty().SetColor(0.2, 1, 0.6 + 0.3 * y)
        if wireframe:
            self.add_ball(1.5, 0, 1, 0.7).GetProperty().SetRepresentationToWireframe()
        if volume:
            self.add_volume()
        for flag in flags:
            flag(self.renderer)

    def add_volume(self):
        image = vtkImageData()
        image.SetDimensions(6, 6, 6)
        image.SetSpacing(0.25, 0.25, 0.25)
        image.SetOrigin(-2, -1.5, 0.5)
        image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
        image.GetPointData().GetScalars().Fill(200)
        mapper = vtkSmartVolumeMapper()
        mapper.SetInputData(image)
        mapper.SetRequestedRenderModeToGPU()
        colour = vtkColorTransferFunction()
        colour.AddRGBPoint(0, 0, 0, 1)
        colour.AddRGBPoint(255, 0.2, 0, 1)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 0.7)
        opacity.AddPoint(255, 0.7)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.GetProperty().SetColor(colour)
        volume.GetProperty().SetScalarOpacity(opacity)
        self.renderer.AddVolume(volume)


def contents(flags):
    return {"wireframe": hidden_lines in flags, "volume": peeled_volumes in flags}


class TestRendererFlags(unittest.TestCase):
    _without = {}

    def without(self, flags, **kinds):
        """The picture of a renderer that has no pass."""
        key = (flags, tuple(sorted(kinds.items())))
        if key not in self._without:
            self._without[key] = Scene(flags, **kinds).picture()
        return self._without[key]

    def check(self, flags, technique, **kinds):
        kinds = {**contents(flags), **kinds}
        right = self.without(flags, **kinds)
        stage = Scene(flags, **kinds)
        rtwshadows.enable_shadows(stage.renderer, technique, 256)
        name = f"{technique}: {', '.join(flag.__name__ for flag in flags)}, {kinds}"
        self.assertEqual(differing(stage.picture(), right), 0, name)

    def test_flags_show(self):
        """Else the others would hold nothing."""
        for flag in (fxaa, ssao, hidden_lines, peeling, peeled_volumes):
            kinds = contents((flag,))
            plain = Scene(**kinds).picture()
            self.assertGreater(differing(plain, Scene((flag,), **kinds).picture(), 4), 15, flag.__name__)
        for one, other in ((fxaa, fxaa_with_options), (ssao, ssao_with_settings)):
            self.assertGreater(
                differing(Scene((one,)).picture(), Scene((other,)).picture(), 2), 10, other.__name__)

    def test_each_flag_with_each_technique(self):
        self.check((), "rtw")
        for technique in TECHNIQUES:
            for flag in FLAGS:
                if technique in ("rtw", "exact") or flag not in (fxaa_with_options, ssao_with_settings, in_order):
                    self.check((flag,), technique)

    def test_together(self):
        for switches in itertools.product((False, True), repeat=4):
            flags = tuple(itertools.compress((fxaa, ssao, hidden_lines, peeling), switches))
            self.check(flags, "rtw", samples=4 if sum(switches) % 2 else 0, wireframe=True)
        self.check((fxaa, ssao, peeled_volumes), "exact", samples=4)

    def test_without_a_shadow_pass(self):
        flags = (fxaa, ssao, peeling)
        right = Scene(flags).picture()
        stage = Scene(flags)
        steps = rtwshadows.vtkShadowRenderStepsPass()
        steps.SetShadowMapPass(None)
        stage.renderer.SetPass(steps)
        self.assertEqual(differing(stage.picture(), right), 0)

    def test_shadows_stay_where_they_are(self):
        """Under occlusion and hidden lines the floor is dark where it is without them, and a still frame is still."""
        for technique in TECHNIQUES:
            for flags in ((), (ssao,), (hidden_lines,)):
                kinds = {**contents(flags), "glass": False}
                light = Scene(flags, 0, **kinds).picture()
                stage = Scene(flags, 1, **kinds)
                shadows = rtwshadows.enable_shadows(stage.renderer, technique, 512)
                dark = (light - stage.picture()).max(axis=2) > 60
                name = f"{technique}: {[flag.__name__ for flag in flags]}"
                if not flags:
                    right = dark
                    self.assertGreater(int(right.sum()), 50)
                elif not kinds["wireframe"]:
                    self.assertLess(int((dark != right).sum()), 15, name)
                else:  # which cast, too
                    self.assertLess(int((right & ~dark).sum()), 0.4 * int(right.sum()), name)
                for _ in range(3):
                    stage.window.Render()
                self.assertEqual(shadows.GetNumberOfLayersDrawn(), 0, name)

    def test_in_a_viewport_beside_another(self):
        """Occlusion is drawn aside, where the viewport begins elsewhere than in the window."""
        pictures = []
        for technique in (None, "rtw", "exact"):
            stage = Scene((fxaa, ssao))
            stage.renderer.SetViewport(0.5, 0.25, 1, 1)
            beside = vtkRenderer()
            beside.SetViewport(0, 0, 0.5, 1)
            beside.SetBackground(0.3, 0.1, 0.2)
            stage.window.AddRenderer(beside)
            if technique:
                rtwshadows.enable_shadows(stage.renderer, technique, 256)
            pictures.append(stage.picture())
        for picture in pictures[1:]:
            self.assertEqual(differing(picture, pictures[0]), 0)

    def test_on_and_off_in_turns(self):
        stage = Scene()
        rtwshadows.enable_shadows(stage.renderer, resolution=256)
        plain = stage.picture()
        for on, off in (("UseFXAAOn", "UseFXAAOff"), ("UseSSAOOn", "UseSSAOOff"),
                        ("UseDepthPeelingOn", "UseDepthPeelingOff")):
            getattr(stage.renderer, on)()
            stage.picture()
            getattr(stage.renderer, off)()
            self.assertEqual(differing(stage.picture(), plain, 0), 0, on)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
