# SPDX-License-Identifier: BSD-3-Clause
"""What lies in texture units for a whole frame, above all the lookup textures of image-based
lighting, is still there after our stages: where no shadow falls the picture is VTK's own."""

import unittest

from pictures import grab

import numpy
import rtwshadows
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

TECHNIQUES = rtwshadows.available_techniques()


def image(colours, size=16):
    """Squares of two colours."""
    picture = vtk.vtkImageData()
    picture.SetDimensions(size, size, 1)
    picture.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 3)
    values = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(size, size, 3)
    v, u = numpy.mgrid[0:size, 0:size] // (size // 4)
    values[:] = numpy.where(((u + v) % 2)[..., None], colours[0], colours[1])
    return picture


def texture(*colours):
    made = vtk.vtkTexture()
    made.SetInputData(image(colours))
    made.MipmapOn()
    made.InterpolateOn()
    return made


def environment():
    cube = vtk.vtkTexture()
    cube.CubeMapOn()
    cube.MipmapOn()
    cube.InterpolateOn()
    for side in range(6):
        colour = (40 + 40 * side, 200 - 30 * side, 80)
        cube.SetInputDataObject(side, image((colour, colour)))
    return cube


def shoot(window, frames=2):
    for _ in range(frames):
        window.Render()
    return grab(window)


class Scene:
    """Objects on the plane z = 0, seen from in front, under a sun and an environment."""

    def __init__(self, samples=0):
        self.renderer = vtk.vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.SetBackground(0, 0, 0.5)
        self.window = vtk.vtkRenderWindow()
        self.window.SetMultiSamples(samples)
        self.window.SetSize(160, 120)
        self.window.AddRenderer(self.renderer)
        self.light = vtk.vtkLight()
        self.light.SetPosition(3, -4, 6)
        self.light.SetFocalPoint(0, 0, 0)
        self.light.SetIntensity(0.6)
        self.renderer.AddLight(self.light)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -9, 7)
        camera.SetFocalPoint(0, 0, 0.3)
        camera.SetViewUp(0, 0, 1)

    def light_by_environment(self, harmonics=False, skybox=False):
        # VTK makes harmonics of a panorama only.
        light = texture((200, 90, 40), (60, 160, 255)) if harmonics else environment()
        self.renderer.SetUseSphericalHarmonics(harmonics)
        self.renderer.GetEnvMapIrradiance().SetIrradianceSize(8)
        self.renderer.GetEnvMapIrradiance().SetIrradianceStep(0.1)
        self.renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(32)
        self.renderer.UseImageBasedLightingOn()
        self.renderer.SetEnvironmentTexture(light)
        if skybox:
            box = vtk.vtkSkybox()
            if harmonics:
                box.SetProjectionToSphere()
            else:
                box.SetProjectionToCube()
            box.SetTexture(light)
            self.renderer.AddActor(box)

    def add(self, source, *, shadow=True):
        source.Update()
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        if not shadow:
            keys = vtk.vtkInformation()
            keys.Set(rtwshadows.vtkAdaptiveShadowMapPass.CASTS_SHADOW(), 0)
            keys.Set(rtwshadows.vtkAdaptiveShadowMapPass.RECEIVES_SHADOW(), 0)
            actor.SetPropertyKeys(keys)
        return actor

    def add_ball(self, x=0, y=0, z=1, shadow=True, mapped=False):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(0.9)
        ball.SetThetaResolution(32)
        ball.SetPhiResolution(32)
        source = ball
        if mapped:
            places = vtk.vtkTextureMapToSphere()
            places.SetInputConnection(ball.GetOutputPort())
            places.PreventSeamOff()
            source = vtk.vtkPolyDataTangents()
            source.SetInputConnection(places.GetOutputPort())
        actor = self.add(source, shadow=shadow)
        actor.SetPosition(x, y, z)
        actor.GetProperty().SetInterpolationToPBR()
        actor.GetProperty().SetColor(1, 0.6, 0.5)
        actor.GetProperty().SetRoughness(0.3)
        return actor

    def add_caster_elsewhere(self):
        """Which no view shows, but every stage has something to do."""
        self.add_ball(0, 30, 1)

    def add_floor(self):
        floor = vtk.vtkPlaneSource()
        floor.SetOrigin(-4, -4, 0)
        floor.SetPoint1(4, -4, 0)
        floor.SetPoint2(-4, 4, 0)
        actor = self.add(floor)
        actor.GetProperty().SetInterpolationToPBR()
        return actor


class TestEnvironmentLight(unittest.TestCase):
    def compare(self, scene, plain, what, most=1):
        """With each technique, the first frame and a still one."""
        for technique in TECHNIQUES:
            rtwshadows.enable_shadows(scene.renderer, technique, resolution=128)
            for frame in ("first", "still"):
                worst = abs(shoot(scene.window, 1) - plain).max()
                self.assertLessEqual(worst, most, f"{what}, {technique}, {frame} frame")
            rtwshadows.disable_shadows(scene.renderer)

    def test_a_ball_that_nothing_shadows(self):
        for harmonics, skybox in ((False, False), (False, True), (True, True)):
            scene = Scene()
            scene.light_by_environment(harmonics, skybox)
            scene.add_ball(shadow=False)
            alone = shoot(scene.window)
            scene.add_caster_elsewhere()
            plain = shoot(scene.window)
            self.assertLessEqual(abs(plain - alone).max(), 1)  # it is elsewhere
            self.compare(scene, plain, f"harmonics {harmonics}, skybox {skybox}")

    def test_several_samples_a_pixel(self):
        scene = Scene(samples=4)
        scene.light_by_environment(skybox=True)
        scene.add_ball(shadow=False)
        scene.add_caster_elsewhere()
        self.compare(scene, shoot(scene.window), "4 samples")

    def test_shadows_take_away_the_sun_alone(self):
        """Lit pixels are as without shadows, those in shadow as without the sun."""
        scene = Scene()
        scene.light_by_environment(skybox=True)
        scene.add_floor()
        scene.add_ball(0, 0, 1.5)
        lit = shoot(scene.window)
        scene.light.SetIntensity(0)
        dark = shoot(scene.window)
        scene.light.SetIntensity(0.6)
        self.assertGreater((abs(lit - dark).max(-1) > 20).mean(), 0.3)
        for technique in TECHNIQUES:
            shadows = rtwshadows.enable_shadows(scene.renderer, technique, resolution=128)
            picture = shoot(scene.window)
            mask = vtk_to_numpy(shadows.GetShadowMask(0).GetPointData().GetScalars())
            mask = mask.reshape(picture.shape[:2])
            self.assertGreater((mask == 0).sum(), 100, technique)
            self.assertLessEqual(abs(picture - lit)[mask == 255].max(), 1, technique)
            self.assertLessEqual(abs(picture - dark)[mask == 0].max(), 1, technique)
            nowhere = (mask == 128)
            self.assertLessEqual(abs(picture - lit)[nowhere].max(), 1, technique)
            rtwshadows.disable_shadows(scene.renderer)

    def test_all_that_uses_texture_units(self):
        """Side by side, each where no shadow falls: maps of colour, normals, material, emission,
        coats and anisotropy, colours looked up by textures, gaussians, translucency, volumes."""
        scene = Scene()
        scene.light_by_environment(skybox=True)
        self.add_materials(scene)
        self.add_lookups(scene)
        for peeled in (False, True):
            scene.renderer.SetUseDepthPeeling(peeled)
            plain = shoot(scene.window)
            self.assertGreater(plain.std(), 20)
            self.compare(scene, plain, f"depth peeling {peeled}")

    @staticmethod
    def add_materials(scene):
        colours = texture((255, 255, 255), (90, 160, 255))
        colours.UseSRGBColorSpaceOn()
        mapped = scene.add_ball(-2.8, 1.5, 1, shadow=False, mapped=True)
        mapped.GetProperty().SetBaseColorTexture(colours)
        mapped.GetProperty().SetNormalTexture(texture((128, 128, 255), (150, 120, 250)))
        mapped.GetProperty().SetORMTexture(texture((255, 60, 200), (200, 160, 20)))
        glowing = texture((80, 0, 0), (0, 0, 0))
        glowing.UseSRGBColorSpaceOn()
        mapped.GetProperty().SetEmissiveTexture(glowing)
        coated = scene.add_ball(-0.8, 1.5, 1, shadow=False, mapped=True)
        coated.GetProperty().SetCoatStrength(1)
        coated.GetProperty().SetCoatRoughness(0.1)
        coated.GetProperty().SetCoatColor(1, 0.5, 0)
        coated.GetProperty().SetEdgeTint(0, 1, 0)
        brushed = scene.add_ball(1.2, 1.5, 1, shadow=False, mapped=True)
        brushed.GetProperty().SetMetallic(1)
        brushed.GetProperty().SetAnisotropy(0.9)
        painted = scene.add_ball(-2.6, -1.2, 1, shadow=False, mapped=True)
        painted.GetProperty().SetInterpolationToPhong()
        painted.SetTexture(texture((255, 0, 0), (0, 255, 0)))

    @staticmethod
    def add_lookups(scene):
        heights = vtk.vtkElevationFilter()
        ball = vtk.vtkSphereSource()
        heights.SetInputConnection(ball.GetOutputPort())
        heights.SetLowPoint(0, 0, -0.5)
        heights.SetHighPoint(0, 0, 0.5)
        looked_up = scene.add(heights, shadow=False)
        looked_up.SetPosition(-0.8, -1.2, 1)
        looked_up.SetScale(1.8)
        looked_up.GetMapper().InterpolateScalarsBeforeMappingOn()
        glass = scene.add_ball(1.4, -1, 1, shadow=False)
        glass.GetProperty().SetOpacity(0.4)
        gaussians = vtk.vtkPointGaussianMapper()
        gaussians.SetInputConnection(ball.GetOutputPort())
        gaussians.SetScaleFactor(0.06)
        points = vtk.vtkActor()
        points.SetMapper(gaussians)
        points.SetPosition(2.6, -1.2, 0.6)
        scene.renderer.AddActor(points)
        cloud = vtk.vtkImageData()
        cloud.SetDimensions(6, 6, 6)
        cloud.SetOrigin(2, 1, 0.5)
        cloud.SetSpacing(0.25, 0.25, 0.25)
        cloud.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 1)
        vtk_to_numpy(cloud.GetPointData().GetScalars())[:] = numpy.arange(216) % 200
        mapper = vtk.vtkSmartVolumeMapper()
        mapper.SetInputData(cloud)
        mapper.SetRequestedRenderModeToGPU()
        opacity = vtk.vtkPiecewiseFunction()
        opacity.AddPoint(0, 0)
        opacity.AddPoint(200, 0.9)
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        volume.GetProperty().SetScalarOpacity(opacity)
        scene.renderer.AddVolume(volume)
        scene.add_caster_elsewhere()


if __name__ == "__main__":
    unittest.main()
