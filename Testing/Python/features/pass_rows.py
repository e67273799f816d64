# SPDX-License-Identifier: BSD-3-Clause
"""Features of renderers and of render passes around, before and behind our steps."""

from .look_rows import opacity_textures, picture_of, translucent, wireframe
from .prop_rows import volumes
from .stage import ball, make, row, vtk


def around(name, **settings):
    """A chain in which a pass of that name has the steps as its delegate."""
    def chain(steps):
        outer = make(name, **settings)
        outer.SetDelegatePass(steps)
        return outer
    return chain


@row
def fxaa(stage):
    stage.chain = around("vtkOpenGLFXAAPass")


@row
def fxaa_by_the_renderer(stage):
    stage.renderer.UseFXAAOn()


def ssao_pass():
    return make("vtkSSAOPass", Radius=0.5, KernelSize=16, Bias=0.02)


@row
def ssao(stage):
    def chain(steps):
        shaded = ssao_pass()
        shaded.SetDelegatePass(steps)
        return shaded
    stage.chain = chain


@row
def ssao_of_opaque_props(stage):
    def chain(steps):
        shaded = ssao_pass()
        shaded.SetDelegatePass(vtk.vtkOpaquePass())
        steps.SetOpaquePass(shaded)
        return steps
    stage.chain = chain


@row
def ssao_by_the_renderer(stage):
    stage.renderer.UseSSAOOn()
    stage.renderer.SetSSAORadius(0.5)
    stage.renderer.SetSSAOKernelSize(16)


@row
def hidden_lines_by_the_renderer(stage):
    wireframe(stage)
    stage.renderer.UseHiddenLineRemovalOn()


@row
def hidden_lines(stage):
    wireframe(stage)

    def chain(steps):
        steps.SetOpaquePass(vtk.vtkHiddenLineRemovalPass())
        return steps
    stage.chain = chain


def peeling(name, **settings):
    def chain(steps):
        peeled = make(name, **settings)
        peeled.SetTranslucentPass(vtk.vtkTranslucentPass())
        steps.SetTranslucentPass(peeled)
        return steps
    return chain


@row
def depth_peeling(stage):
    translucent(stage)
    stage.chain = peeling("vtkDepthPeelingPass", MaximumNumberOfPeels=6)


@row
def dual_depth_peeling(stage):
    translucent(stage)
    stage.chain = peeling("vtkDualDepthPeelingPass", MaximumNumberOfPeels=6)


@row
def dual_depth_peeling_of_opacity_textures(stage):
    opacity_textures(stage)
    stage.chain = peeling("vtkDualDepthPeelingPass", MaximumNumberOfPeels=6)


@row
def order_independent_translucency(stage):
    translucent(stage)
    stage.chain = peeling("vtkOrderIndependentTranslucentPass")


@row
def translucency_in_order(stage):
    translucent(stage)

    def chain(steps):
        steps.SetTranslucentPass(vtk.vtkTranslucentPass())
        return steps
    stage.chain = chain


@row
def depth_peeling_by_the_renderer(stage):
    translucent(stage)
    stage.renderer.UseDepthPeelingOn()
    stage.renderer.SetMaximumNumberOfPeels(6)


@row
def depth_peeling_of_few_layers(stage):
    translucent(stage)
    stage.renderer.UseDepthPeelingOn()
    stage.renderer.SetMaximumNumberOfPeels(1)


@row
def depth_peeling_with_volumes(stage):
    translucent(stage)
    volumes(stage)
    stage.renderer.UseDepthPeelingOn()


@row
def depth_peeling_of_volumes(stage):
    depth_peeling_with_volumes(stage)
    stage.renderer.UseDepthPeelingForVolumesOn()


@row
def depth_peeling_of_volumes_alone(stage):
    volumes(stage)
    stage.renderer.UseDepthPeelingOn()
    stage.renderer.UseDepthPeelingForVolumesOn()


@row
def tone_mapping(stage):
    stage.chain = around("vtkToneMappingPass", ToneMappingType=vtk.vtkToneMappingPass.GenericFilmic)


@row
def tone_mapping_by_reinhard(stage):
    stage.chain = around("vtkToneMappingPass", ToneMappingType=vtk.vtkToneMappingPass.Reinhard)


@row
def eye_dome_lighting(stage):
    stage.chain = around("vtkEDLShading")


@row
def depth_of_field(stage):
    stage.renderer.GetActiveCamera().SetFocalDisk(0.3)
    stage.chain = around("vtkDepthOfFieldPass", AutomaticFocalDistance=True)


@row
def blur(stage):
    stage.chain = around("vtkGaussianBlurPass")


@row
def sobel(stage):
    stage.chain = around("vtkSobelGradientMagnitudePass")


@row
def motion_blur(stage):
    stage.chain = around("vtkSimpleMotionBlurPass", SubFrames=3)
    once = stage.photograph

    def photograph():  # as many frames as it mixes
        for _ in range(3):
            shown = once()
        return shown
    stage.photograph = photograph


@row
def framebuffer_pass(stage):
    def chain(steps):
        outer = make("vtkFramebufferPass")
        outer.SetDelegatePass(steps)
        return outer
    stage.chain = chain


@row
def steps_in_a_sequence(stage):
    def chain(steps):
        passes = vtk.vtkRenderPassCollection()
        passes.AddItem(steps)
        return make("vtkSequencePass", Passes=passes)
    stage.chain = chain


@row
def default_pass_for_the_opaque_step(stage):
    translucent(stage)

    def chain(steps):
        steps.SetOpaquePass(vtk.vtkDefaultPass())
        steps.SetTranslucentPass(None)
        return steps
    stage.chain = chain


@row
def all_of_them(stage):
    translucent(stage)
    volumes(stage)

    def chain(steps):
        shaded = ssao_pass()
        shaded.SetDelegatePass(vtk.vtkOpaquePass())
        steps.SetOpaquePass(shaded)
        peeling("vtkDualDepthPeelingPass")(steps)
        return around("vtkOpenGLFXAAPass")(around("vtkToneMappingPass")(steps))
    stage.chain = chain


@row
def skybox(stage):
    stage.renderer.AddActor(make("vtkSkybox", Texture=environment()))


@row
def skybox_behind_translucent(stage):
    skybox(stage)
    translucent(stage)


def environment():
    cube = make("vtkTexture", CubeMap=True, Mipmap=True, Interpolate=True)
    for side in range(6):
        cube.SetInputDataObject(side, picture_of(3))
    return cube


@row
def environment_light(stage):
    stage.ball.GetProperty().SetInterpolationToPBR()
    stage.renderer.UseSphericalHarmonicsOff()
    stage.renderer.GetEnvMapIrradiance().SetIrradianceSize(8)
    stage.renderer.GetEnvMapLookupTable().SetLUTSamples(8)
    stage.renderer.UseImageBasedLightingOn()
    stage.renderer.SetEnvironmentTexture(environment())


@row
def gradient_background(stage):
    stage.renderer.GradientBackgroundOn()
    stage.renderer.SetBackground2(0.9, 0.5, 0.1)


@row
def textured_background(stage):
    stage.renderer.TexturedBackgroundOn()
    stage.renderer.SetBackgroundTexture(make("vtkTexture", InputData=picture_of(3)))


@row
def gradient_background_and_fxaa(stage):
    gradient_background(stage)
    fxaa(stage)


@row
def transparent_background(stage):
    stage.window.AlphaBitPlanesOn()
    stage.renderer.SetBackgroundAlpha(0)


@row
def transparent_background_with_translucent(stage):
    transparent_background(stage)
    translucent(stage)


@row
def kept_colours(stage):
    """A renderer that draws over what there is, as on a picture that a program put there."""
    stage.renderer.PreserveColorBufferOn()
    keep(stage)


@row
def kept_depths(stage):
    stage.renderer.PreserveDepthBufferOn()
    keep(stage)


@row
def kept_all(stage):
    stage.renderer.EraseOff()
    keep(stage)


def keep(stage):
    """Puts a ball there by another renderer, in the same layer and viewport, drawn before."""
    before = make("vtkRenderer", Background=(0.3, 0, 0), AutomaticLightCreation=False)
    before.AddActor(stage.add(ball((-1.5, -2.5, 1), 0.8), (1, 0, 1)))
    stage.renderer.RemoveActor(stage.renderer.GetActors().GetLastActor())
    before.AddLight(stage.sun)
    before.SetActiveCamera(stage.renderer.GetActiveCamera())
    stage.window.RemoveRenderer(stage.renderer)
    stage.window.AddRenderer(before)
    stage.window.AddRenderer(stage.renderer)


@row
def coverage_culler(stage):
    stage.renderer.GetCullers().GetLastItem()
    culler = vtk.vtkFrustumCoverageCuller()
    culler.SetMinimumCoverage(0.02)
    stage.renderer.GetCullers().RemoveAllItems()
    stage.renderer.AddCuller(culler)
