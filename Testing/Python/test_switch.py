# SPDX-License-Identifier: BSD-3-Clause
"""enable_shadows and disable_shadows, on a ball above a floor."""

import gc
import sys
import unittest

from pictures import grab

import rtwshadows
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkSSAOPass


def add(renderer, source):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)


class Plotter:
    """As PyVista's and vedo's: a renderer, and more."""

    def __init__(self):
        self.renderer = vtkRenderer()
        floor = vtkPlaneSource()
        floor.SetOrigin(-3, -3, 0)
        floor.SetPoint1(3, -3, 0)
        floor.SetPoint2(-3, 3, 0)
        add(self.renderer, floor)
        ball = vtkSphereSource()
        ball.SetCenter(0, 0, 1)
        ball.SetThetaResolution(40)
        ball.SetPhiResolution(40)
        add(self.renderer, ball)
        light = vtkLight()
        light.SetPosition(3, 0, 3)
        light.SetFocalPoint(0, 0, 0)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(light)
        self.window = vtkRenderWindow()
        self.window.SetSize(160, 120)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -8, 8)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        self.renderer.ResetCameraClippingRange()

    def picture(self):
        self.window.Render()
        return grab(self.window).reshape(-1, 3)


class TestSwitch(unittest.TestCase):
    def test_every_technique_casts_a_shadow(self):
        self.assertIn("rtw", rtwshadows.available_techniques())
        plotter = Plotter()
        without = plotter.picture()
        for technique in rtwshadows.available_techniques():
            shadows = rtwshadows.enable_shadows(plotter, technique)
            self.assertEqual(shadows.GetResolution(), 1024)
            darker = (without - plotter.picture()).max(axis=1) > 60
            self.assertTrue(0.005 < darker.mean() < 0.2, f"{technique}: {darker.mean()}")
            rtwshadows.disable_shadows(plotter)
            self.assertTrue((plotter.picture() == without).all(), technique)

    def test_restores_the_pass_there_was(self):
        plotter = Plotter()
        for before in (None, vtkRenderStepsPass()):
            plotter.renderer.SetPass(before)
            without = plotter.picture()
            rtwshadows.enable_shadows(plotter.renderer)
            self.assertIsInstance(
                plotter.renderer.GetPass(), rtwshadows.vtkShadowRenderStepsPass)
            plotter.picture()
            rtwshadows.enable_shadows(plotter.renderer, "uniform")
            plotter.picture()
            gc.collect()
            rtwshadows.disable_shadows(plotter.renderer)
            self.assertIs(plotter.renderer.GetPass(), before)
            rtwshadows.disable_shadows(plotter.renderer)
            self.assertIs(plotter.renderer.GetPass(), before)
            self.assertTrue((plotter.picture() == without).all())

    def test_leaves_a_pass_set_since(self):
        plotter = Plotter()
        rtwshadows.enable_shadows(plotter)
        mine = vtkSSAOPass()
        plotter.renderer.SetPass(mine)
        rtwshadows.disable_shadows(plotter)
        self.assertIs(plotter.renderer.GetPass(), mine)
        plotter.renderer.SetPass(None)

    def test_replaces(self):
        plotter = Plotter()
        first = rtwshadows.enable_shadows(plotter, resolution=256)
        plotter.picture()
        second = rtwshadows.enable_shadows(plotter, "uniform", 512, focus_on_view=False)
        plotter.picture()
        self.assertIsNot(first, second)
        self.assertIs(plotter.renderer.GetPass().GetShadowMapPass(), second)
        self.assertEqual(second.GetResolution(), 512)
        self.assertFalse(second.GetFocusOnView())

    def test_words_for_enumerators(self):
        plotter = Plotter()
        for word in ("nearest", "bilinear", "BILINEAR", "pcf", "soft"):
            shadows = rtwshadows.enable_shadows(plotter, filter=word)
            self.assertEqual(shadows.GetFilter(), getattr(shadows, word.upper()))
        for word in ("square", "critical", "automatic"):
            shadows = rtwshadows.enable_shadows(
                plotter, "perspective", 128, resolution_split=word)
            self.assertEqual(shadows.GetResolutionSplit(), getattr(shadows, f"SPLIT_{word.upper()}"))
        shadows = rtwshadows.enable_shadows(plotter, "perspective", 128, resolution_ratio=0.5)
        self.assertEqual(shadows.GetResolutionSplit(), shadows.SPLIT_BY_RATIO)
        plotter.picture()
        self.assertEqual(shadows.GetShadowMapImage(0, 0).GetDimensions(), (90, 181, 1))

    def test_perspective(self):
        plotter = Plotter()
        for word in ("psm", "lispsm", "tsm", "unwarped"):
            shadows = rtwshadows.enable_shadows(plotter, "perspective", parameterization=word)
            self.assertEqual(shadows.GetParameterization(), getattr(shadows, word.upper()))
        self.assertIsNone(shadows.GetWarpImage(0))
        shadows = rtwshadows.enable_shadows(plotter, "perspective", eta=0.5)
        self.assertEqual(shadows.GetParameterization(), shadows.BY_ETA)
        plotter.picture()
        self.assertEqual(shadows.GetWarpImage(0).GetDimensions(), (3, 3, 1))
        shadows.SetNearDistance(7)
        self.assertEqual(shadows.GetPerspectiveWarp().GetNearDistance(), 7)
        self.assertEqual(shadows.GetParameterization(), shadows.BY_NEAR_DISTANCE)

    def test_soft_shadows(self):
        plotter = Plotter()
        shadows = rtwshadows.enable_shadows(
            plotter, filter="soft", filter_radius=0.2, filter_jitter=True)
        self.assertEqual(shadows.GetFilter(), shadows.SOFT)
        self.assertEqual(shadows.GetFilterRadius(), 0.2)
        self.assertTrue(shadows.GetFilterJitter())
        soft = len(set(map(tuple, plotter.picture())))
        shadows.SetFilterToNearest()
        self.assertGreater(soft, len(set(map(tuple, plotter.picture()))) + 20)

    def test_debug_view(self):
        plotter = Plotter()
        shadows = rtwshadows.enable_shadows(plotter)
        self.assertEqual(shadows.GetDebugView(), shadows.NONE)
        lit = plotter.picture()
        pictures = []
        for word in ("shadow", "aliasing_error", "importance", "warp_grid", "layers"):
            shadows = rtwshadows.enable_shadows(plotter, debug_view=word, debug_light=0)
            self.assertEqual(shadows.GetDebugView(), getattr(shadows, word.upper()))
            pictures.append(plotter.picture())
            for other in [lit] + pictures[:-1]:
                self.assertGreater((abs(pictures[-1] - other).max(axis=1) > 10).mean(), 0.02, word)
        shadows.SetDebugViewToNone()
        self.assertTrue((plotter.picture() == lit).all())
        with self.assertRaisesRegex(ValueError, "debug_view='maps'.*aliasing"):
            rtwshadows.enable_shadows(plotter, debug_view="maps")

    def test_images(self):
        plotter = Plotter()
        shadows = rtwshadows.enable_shadows(plotter, resolution=256, importance_resolution=64)
        self.assertIsNone(shadows.GetAliasingErrorImage(0))
        self.assertIsNone(shadows.GetImportanceImage(0))
        plotter.picture()
        image = shadows.GetAliasingErrorImage(0)
        self.assertEqual(image.GetDimensions(), (160, 120, 1))
        along = vtk_to_numpy(image.GetPointData().GetScalars())
        self.assertEqual(along.shape, (160 * 120, 2))
        facing = along.max(axis=1) > 0
        self.assertTrue(0.2 < facing.mean() < 0.95)
        coarse = along[facing].max(axis=1).mean()
        shadows.SetResolution(512)
        plotter.picture()
        fine = vtk_to_numpy(shadows.GetAliasingErrorImage(0).GetPointData().GetScalars())
        self.assertAlmostEqual(coarse / fine[facing].max(axis=1).mean(), 2, 2)
        image = shadows.GetImportanceImage(0)
        self.assertEqual(image.GetDimensions(), (64, 2, 1))
        cells = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(2, 64, 2)
        warp = vtk_to_numpy(shadows.GetWarpImage(0).GetPointData().GetScalars()).reshape(2, 65)
        for axis in range(2):
            collected, used = cells[axis].T
            self.assertTrue((collected >= 0).all() and (used > 0).all())
            share = used / used.sum() - (warp[axis, 1:] - warp[axis, :-1])
            self.assertLess(abs(share).max(), 1e-5)
        self.assertIsNone(shadows.GetImportanceImage(1))
        self.assertIsNone(shadows.GetImportanceImage(0, 1))
        self.assertIsNone(shadows.GetAliasingErrorImage(-1))

    def test_light_plane(self):
        plotter = Plotter()
        shadows = rtwshadows.enable_shadows(plotter, resolution=64)
        self.assertEqual(shadows.GetPredictedError(0), -1)
        self.assertEqual(shadows.GetLightPlaneTurn(), shadows.TURN_OFF)
        plotter.picture()
        coarse = shadows.GetPredictedError(0)
        for word in ("view_aligned", "automatic", "off"):
            shadows = rtwshadows.enable_shadows(plotter, resolution=128, light_plane_turn=word)
            self.assertEqual(shadows.GetLightPlaneTurn(), getattr(shadows, f"TURN_{word.upper()}"))
            plotter.picture()
            self.assertGreater(coarse, 1.3 * shadows.GetPredictedError(0))
            self.assertGreater(shadows.GetPredictedError(0), 0)
        with self.assertRaisesRegex(ValueError, "light_plane_turn='left'.*automatic, minimalfrustum, off, view"):
            rtwshadows.enable_shadows(plotter, light_plane_turn="left")

    def test_importance(self):
        plotter = Plotter()
        without = plotter.picture()
        rtw = rtwshadows.vtkRTWShadowMapPass
        shadows = rtwshadows.enable_shadows(
            plotter, importance=rtw.SQRT_DEMAND | rtw.SHADOW_EDGE | rtw.USER_FUNCTION,
            analysis="hybrid", light_image_resolution=256, edge_threshold=0.002,
            surface_normal_bonus=1, interest="sphere", interest_centre=(1, 2, 3),
            interest_radius=2, interest_view_radius=0.3, interest_bonus=3,
            user_function="0.5 + luminance")
        self.assertEqual(shadows.GetAnalysis(), rtw.HYBRID)
        self.assertEqual(shadows.GetLightImageResolution(), 256)
        self.assertEqual(shadows.GetInterest(), rtw.SPHERE)
        self.assertEqual(tuple(shadows.GetInterestCentre()), (1, 2, 3))
        self.assertEqual(shadows.GetUserFunction(), "0.5 + luminance")
        darker = (without - plotter.picture()).max(axis=1) > 60
        self.assertTrue(0.005 < darker.mean() < 0.2)

    def test_warping_maps(self):
        plotter = Plotter()
        without = plotter.picture()
        shadows = rtwshadows.enable_shadows(
            plotter, temporal_blending=0.5, snapping=True, cull_empty_cells=True)
        self.assertEqual(shadows.GetTemporalBlending(), 0.5)
        self.assertTrue(shadows.GetSnapping())
        self.assertTrue(shadows.GetCullEmptyCells())
        for _ in range(3):
            darker = (without - plotter.picture()).max(axis=1) > 60
            self.assertTrue(0.005 < darker.mean() < 0.2)
        self.assertEqual(shadows.GetNumberOfLayersDrawn(), 1)
        for _ in range(12):
            plotter.picture()
        self.assertEqual(shadows.GetNumberOfLayersDrawn(), 0)

    def test_errors_change_nothing(self):
        plotter = Plotter()
        rtwshadows.enable_shadows(plotter)
        before = plotter.renderer.GetPass()
        with self.assertRaisesRegex(ValueError, "'fuzzy' is not known; available: .*'rtw'"):
            rtwshadows.enable_shadows(plotter, "fuzzy")
        with self.assertRaisesRegex(TypeError, "no property 'resolutoin'.*focus_on_view"):
            rtwshadows.enable_shadows(plotter, resolutoin=3)
        with self.assertRaisesRegex(ValueError, "filter='blur'"):
            rtwshadows.enable_shadows(plotter, filter="blur")
        with self.assertRaisesRegex(TypeError, "vtkRenderer.*not Mock"):
            rtwshadows.enable_shadows(type("Mock", (), {})())
        with self.assertRaises(TypeError):
            rtwshadows.disable_shadows(None)
        self.assertIs(plotter.renderer.GetPass(), before)

    def test_planned_technique(self):
        missing = {"notw", "perspective", "exact"} - set(rtwshadows.available_techniques())
        for technique in missing:
            with self.assertRaisesRegex(ValueError, "not in this build; available: .*'uniform'"):
                rtwshadows.enable_shadows(Plotter(), technique)

    def test_before_the_first_render_and_after_finalize(self):
        plotter = Plotter()
        rtwshadows.enable_shadows(plotter)
        rtwshadows.disable_shadows(plotter)
        rtwshadows.enable_shadows(plotter)
        first = plotter.picture()
        plotter.window.Finalize()
        self.assertLess(abs(plotter.picture() - first).max(), 3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
