# SPDX-License-Identifier: BSD-3-Clause
"""What a renderer asks for by its flags it gets with our steps as without a pass. An attenuation of 0.00001 has all of
the shadows drawn and none of them seen, not even by a threshold of FXAA that the least step of a colour would cross."""

import itertools
import sys
import unittest

from ball_on_floor import TECHNIQUES, Stage, differing, rtwshadows
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkFXAAOptions,
    vtkRenderer,
    vtkVolume,
)
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


def clear_flags(renderer):
    renderer.UseFXAAOff()
    renderer.SetFXAAOptions(vtkFXAAOptions())
    renderer.UseSSAOOff()
    renderer.SetSSAOKernelSize(32)
    renderer.SSAOBlurOff()
    renderer.UseHiddenLineRemovalOff()
    renderer.UseDepthPeelingOff()
    renderer.UseDepthPeelingForVolumesOff()
    if hasattr(renderer, "SetUseOIT"):
        renderer.UseOITOn()


FLAGS = (fxaa, fxaa_with_options, ssao, ssao_with_settings, hidden_lines, peeling, peeled_volumes, in_order)


class Scene(Stage):
    """With what each flag is for: glass behind glass, a volume, a wireframe before a face."""

    def __init__(self, flags=(), attenuation=1e-9, samples=0, glass=True, wireframe=False, volume=False):
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


class TestRendererFlags(unittest.TestCase):
    @staticmethod
    def picture(stage, flags):
        clear_flags(stage.renderer)
        for flag in flags:
            flag(stage.renderer)
        return stage.picture()

    def check(self, choices, techniques, **kinds):
        """Each choice of flags, one after the other in the same window, and none at the end."""
        without = Scene(wireframe=True, volume=True, **kinds)
        right = [self.picture(without, flags) for flags in choices]
        for technique in techniques:
            stage = Scene(wireframe=True, volume=True, **kinds)
            rtwshadows.enable_shadows(stage.renderer, technique, 256)
            for flags, picture in zip(choices, right):
                name = f"{technique}: {', '.join(flag.__name__ for flag in flags)}, {kinds}"
                self.assertEqual(differing(self.picture(stage, flags), picture), 0, name)
        return right

    def test_each_flag_with_each_technique(self):
        pictures = self.check([()] + [(flag,) for flag in FLAGS] + [()], ("rtw",))
        self.check([(fxaa,), (ssao,), (hidden_lines,), (peeled_volumes,)],
                   [technique for technique in TECHNIQUES if technique != "rtw"])
        # Else there would be nothing to see.
        by_flag = dict(zip(FLAGS, pictures[1:]))
        for flag in (fxaa, ssao, hidden_lines, peeling, peeled_volumes):
            self.assertGreater(differing(pictures[0], by_flag[flag], 4), 12, flag.__name__)
        for one, other in ((fxaa, fxaa_with_options), (ssao, ssao_with_settings), (peeling, peeled_volumes)):
            self.assertGreater(differing(by_flag[one], by_flag[other], 2), 3, other.__name__)

    def test_together(self):
        choices = [tuple(itertools.compress((fxaa, ssao, hidden_lines, peeling), switches))
                   for switches in itertools.product((False, True), repeat=4)]
        for technique, samples in (("rtw", 4), ("exact", 0)):
            self.check(choices + [(fxaa, ssao, peeled_volumes)], (technique,), samples=samples)

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
                kinds = {"glass": False, "wireframe": hidden_lines in flags}
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
        """Smaller than the window. In one that begins elsewhere VTK 9.1 shows no occlusion, and nothing that it is
        of."""
        pictures = []
        for technique in (None, "rtw", "exact"):
            stage = Scene((fxaa, ssao))
            stage.renderer.SetViewport(0, 0, 0.5, 0.75)
            beside = vtkRenderer()
            beside.SetViewport(0.5, 0, 1, 1)
            beside.SetBackground(0.3, 0.1, 0.2)
            stage.window.AddRenderer(beside)
            if technique:
                rtwshadows.enable_shadows(stage.renderer, technique, 256)
            pictures.append(stage.picture())
        for picture in pictures[1:]:
            self.assertEqual(differing(picture, pictures[0]), 0)

    def test_shadows_in_such_a_viewport(self):
        dark = []
        for flags in ((), (ssao,)):
            pictures = []
            for technique in (None, "exact"):
                stage = Scene(flags, 1, glass=False)
                stage.renderer.SetViewport(0, 0, 0.5, 0.75)
                if technique:
                    rtwshadows.enable_shadows(stage.renderer, technique)
                pictures.append(stage.picture())
            dark.append(int(((pictures[0] - pictures[1]).max(axis=2) > 60).sum()))
        self.assertGreater(dark[0], 15)
        self.assertLess(abs(dark[1] - dark[0]), 0.2 * dark[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
