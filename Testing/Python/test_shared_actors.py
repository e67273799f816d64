# SPDX-License-Identifier: BSD-3-Clause
"""Actors that several viewports share: no frame builds shaders for them, and each viewport has its own shadows."""

import unittest

from pictures import grab

import rtwshadows
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkOpenGLSphereMapper,
    vtkRenderPassCollection,
    vtkSequencePass,
)


def shape(source):
    source.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(source.GetOutput())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def scene(only_surfaces):
    floor = vtkPlaneSource()
    floor.SetOrigin(-4, -4, 0)
    floor.SetPoint1(4, -4, 0)
    floor.SetPoint2(-4, 4, 0)
    ball = vtkSphereSource()
    ball.SetCenter(0, 0, 1.5)
    actors = [shape(floor), shape(ball)]
    if not only_surfaces:
        points = vtkPoints()
        points.InsertNextPoint(-2, 0, 1)
        points.InsertNextPoint(2, 0, 1)
        places = vtkPolyData()
        places.SetPoints(points)
        mapper = vtkOpenGLSphereMapper()
        mapper.SetInputData(places)
        mapper.SetRadius(0.4)
        actors.append(vtkActor())
        actors[-1].SetMapper(mapper)
        glass = vtkSphereSource()
        glass.SetCenter(0, 1, 3)
        actors.append(shape(glass))
        actors[-1].GetProperty().SetOpacity(0.5)
    return actors


class Views:
    """Viewports side by side, each with a light of its own."""

    def __init__(self, techniques, only_surfaces=False, shared=True, samples=0, classic=False,
                 one_pass=False, **settings):
        self.window = vtkRenderWindow()
        self.window.SetSize(240, 120)
        self.window.SetMultiSamples(samples)
        self.renderers = []
        self.passes = []
        actors = scene(only_surfaces)
        for i, technique in enumerate(techniques):
            renderer = vtkRenderer()
            renderer.SetViewport(i / len(techniques), 0, (i + 1) / len(techniques), 1)
            light = vtkLight()
            light.SetPosition(2, 3 * i - 1, 5)
            light.SetFocalPoint(0, 0, 0)
            renderer.AutomaticLightCreationOff()
            renderer.AddLight(light)
            camera = renderer.GetActiveCamera()
            camera.SetPosition(0, -9, 8)
            camera.SetFocalPoint(0, 0, 0.5)
            camera.SetViewUp(0, 0, 1)
            camera.SetClippingRange(3, 30)
            for actor in actors if shared else scene(only_surfaces):
                renderer.AddActor(actor)
            self.window.AddRenderer(renderer)
            self.renderers.append(renderer)
            if one_pass and i > 0:
                renderer.SetPass(self.renderers[0].GetPass())
                continue
            shadows = rtwshadows.enable_shadows(renderer, technique, 256, **settings)
            self.passes.append(shadows)
            if classic:
                renderer.SetPass(self.classic_chain(shadows))

    @staticmethod
    def classic_chain(shadows):
        passes = vtkRenderPassCollection()
        passes.AddItem(shadows.GetShadowMapBakerPass())
        passes.AddItem(shadows)
        sequence = vtkSequencePass()
        sequence.SetPasses(passes)
        camera = vtkCameraPass()
        camera.SetDelegatePass(sequence)
        return camera

    def builds(self):
        return sum(shadows.GetNumberOfShaderBuilds() for shadows in self.passes)

    def render(self, frames, turn=0):
        before = self.builds()
        for _ in range(frames):
            for renderer in self.renderers:
                renderer.GetActiveCamera().Azimuth(turn)
            self.window.Render()
        return self.builds() - before

    def picture(self):
        return grab(self.window).reshape(-1, 3)


class TestSharedActors(unittest.TestCase):
    def check(self, *arguments, **settings):
        with self.subTest(arguments=arguments, settings=settings):
            views = Views(*arguments, **settings)
            self.assertGreater(views.render(2), 0)
            self.assertEqual(views.render(3), 0, "builds of still frames")
            for shadows in views.passes:
                self.assertEqual(shadows.GetNumberOfLayersDrawn(), 0)
            self.assertEqual(views.render(3, turn=5), 0, "builds of moving frames")
            # What is right: as where each viewport has actors of its own.
            apart = Views(*arguments, **settings, shared=False)
            apart.render(2)
            apart.render(3)
            apart.render(3, turn=5)
            differing = abs(views.picture() - apart.picture()).max(axis=1) > 8
            self.assertLessEqual(int(differing.sum()), 3)

    def test_equal_techniques(self):
        for views in (2, 4):
            for technique in ("rtw", "exact"):
                self.check([technique] * views)

    def test_one_viewport(self):
        for chain in (False, True):
            self.check(["rtw"], classic=chain)

    def test_other_ways(self):
        self.check(["rtw"] * 2, classic=True)
        self.check(["rtw"] * 2, samples=4)
        self.check(["rtw"] * 2, debug_view="shadow")
        self.check(["rtw"] * 2, view_sample_source="previous_frame")

    def test_surfaces_of_different_techniques(self):
        """What looks its shadows up in a mask has the same code in all of them."""
        self.check(["rtw", "exact"], True)
        self.check(["uniform", "notw", "perspective", "cascades"], True)

    def test_one_pass_of_two_renderers(self):
        """It is asked for by mistake, and costs reuse, but the picture is right."""
        views, apart = Views(["rtw"] * 2, one_pass=True), Views(["rtw"] * 2)
        self.assertGreater(views.render(2), 0)
        self.assertEqual(views.render(3, turn=5), 0)
        apart.render(2)
        apart.render(3, turn=5)
        differing = abs(views.picture() - apart.picture()).max(axis=1) > 8
        self.assertLessEqual(int(differing.sum()), 24)


if __name__ == "__main__":
    unittest.main()
