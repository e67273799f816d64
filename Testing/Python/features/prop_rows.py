# SPDX-License-Identifier: BSD-3-Clause
"""Features of props and mappers."""

from .look_rows import clipped_capped_by_filter, picture_of, scalars, translucent
from .stage import ball, box, fed, make, mapper_of, row, vtk


@row
def unstructured_grid(stage):
    grid = fed(vtk.vtkAppendFilter(), ball((0.5, 0, 1.2)))
    stage.ball.SetMapper(fed(vtk.vtkDataSetMapper(), grid))


@row
def composite(stage):
    blocks = make("vtkMultiBlockDataSet", NumberOfBlocks=3)
    for i in range(3):
        source = ball((0.6 * i - 0.8, -1.5, 0.5), 0.5)
        source.Update()
        blocks.SetBlock(i, source.GetOutput())
    mapper = vtk.vtkCompositePolyDataMapper2()
    mapper.SetInputDataObject(blocks)
    attributes = vtk.vtkCompositeDataDisplayAttributes()
    mapper.SetCompositeDataDisplayAttributes(attributes)
    attributes.SetBlockColor(blocks.GetBlock(0), (1, 0, 0))
    attributes.SetBlockVisibility(blocks.GetBlock(1), False)
    stage.renderer.AddActor(make("vtkActor", Mapper=mapper))


@row
def glyphs(stage):
    places = make("vtkPlaneSource", Origin=(-3, -3, 0.3), Point1=(3, -3, 0.3),
                  Point2=(-3, 3, 0.3), Resolution=(4, 4))
    mapper = fed(fed(vtk.vtkGlyph3DMapper(), places), ball((0, 0, 0), 0.25, 8), 1)
    mapper.ScalingOff()
    stage.renderer.AddActor(make("vtkActor", Mapper=mapper))


@row
def gaussian_points(stage):
    mapper = make("vtkPointGaussianMapper", ScaleFactor=0.15)
    ball_of_points = ball((0, -1.5, 1), 0.9, 8)  # not at random
    fed(mapper, ball_of_points)
    stage.renderer.AddActor(make("vtkActor", Mapper=mapper))


@row
def sphere_imposters(stage):
    mapper = make("vtkOpenGLSphereMapper", Radius=0.4)
    fed(mapper, make("vtkPlaneSource", Origin=(-3, -3, 0.4), Point1=(3, -3, 0.4),
                     Point2=(-3, 3, 0.4), Resolution=(3, 3)))
    stage.renderer.AddActor(make("vtkActor", Mapper=mapper))


@row
def own_shaders(stage):
    shaders = stage.ball.GetShaderProperty()
    shaders.AddFragmentShaderReplacement(
        "//VTK::Light::Impl", True,
        "//VTK::Light::Impl\n  gl_FragData[0].rgb *= 0.5 + 0.5 * sin(20.0 * vertexVC.y);\n", False)


@row
def lit_from_behind(stage):
    stage.floor.SetScale(1, 1, -1)
    stage.sun.SetPosition(3, 2, -5)


@row
def one_sided_lighting(stage):
    clipped_capped_by_filter(stage)
    stage.renderer.TwoSidedLightingOff()


@row
def levels_of_detail(stage):
    """Which level VTK draws depends on how long each took, so that this row may show either."""
    actor = vtk.vtkLODActor()
    actor.SetMapper(stage.ball.GetMapper())
    actor.AddLODMapper(mapper_of(ball((0.5, 0, 1.2), 1.0, 20)))
    stage.renderer.RemoveActor(stage.ball)
    stage.renderer.AddActor(actor)


@row
def levels_of_detail_of_a_prop(stage):
    lod = vtk.vtkLODProp3D()
    coarse = lod.AddLOD(mapper_of(ball((0.5, 0, 1.2), 1.0, 6)), 0.0)
    lod.AddLOD(stage.ball.GetMapper(), 0.0)
    lod.AutomaticLODSelectionOff()
    lod.SetSelectedLODID(coarse)
    stage.renderer.RemoveActor(stage.ball)
    stage.renderer.AddViewProp(lod)


@row
def quadric_levels_of_detail(stage):
    actor = vtk.vtkQuadricLODActor()
    make("vtkGenericRenderWindowInteractor", RenderWindow=stage.window)  # which it asks
    actor.SetMapper(stage.ball.GetMapper())
    stage.renderer.RemoveActor(stage.ball)
    stage.renderer.AddActor(actor)


@row
def assemblies(stage):
    inner = make("vtkAssembly", Position=(0, -1, 0))
    inner.AddPart(stage.ball)
    outer = make("vtkAssembly", Orientation=(0, 0, 20))
    outer.AddPart(inner)
    outer.AddPart(stage.box)
    for actor in (stage.ball, stage.box):
        stage.renderer.RemoveActor(actor)
    stage.renderer.AddActor(outer)


@row
def prop_assemblies(stage):
    assembly = vtk.vtkPropAssembly()
    assembly.AddPart(stage.ball)
    assembly.AddPart(stage.box)
    for actor in (stage.ball, stage.box):
        stage.renderer.RemoveActor(actor)
    stage.renderer.AddViewProp(assembly)


@row
def axes(stage):
    stage.renderer.AddActor(make("vtkAxesActor", TotalLength=(2, 2, 2)))


@row
def cube_axes(stage):
    axes3d = make("vtkCubeAxesActor", Bounds=(-3, 3, -3, 3, 0, 2), Camera=stage.renderer.GetActiveCamera())
    stage.renderer.AddActor(axes3d)


@row
def followers(stage):
    text = make("vtkVectorText", Text="VTK")
    follower = make("vtkFollower", Mapper=mapper_of(text), Camera=stage.renderer.GetActiveCamera(),
                    Position=(-1, -2, 1), Scale=(0.8, 0.8, 0.8))
    stage.renderer.AddActor(follower)


@row
def text(stage):
    prop = make("vtkTextActor", Input="text", Position=(20, 20))
    stage.renderer.AddActor2D(prop)
    stage.renderer.AddActor(make("vtkBillboardTextActor3D", Input="board", Position=(0, -2, 1)))
    stage.renderer.AddActor(make("vtkTextActor3D", Input="three", Scale=(0.05, 0.05, 0.05),
                                 Position=(-2, -3, 0.5)))


@row
def scalar_bar(stage):
    scalars(stage)
    bar = make("vtkScalarBarActor", LookupTable=stage.ball.GetMapper().GetLookupTable())
    stage.renderer.AddActor2D(bar)


def noise(size=12):
    image = make("vtkRTAnalyticSource", WholeExtent=(0, size, 0, size, 0, size),
                 Center=(size / 2, size / 2, size / 2))
    image.Update()
    return image.GetOutput()


def add_volume(stage, name="vtkGPUVolumeRayCastMapper", **settings):
    data = noise()
    data.SetSpacing(0.15, 0.15, 0.15)
    data.SetOrigin(-1.4, -2.6, 0.2)
    mapper = make(name, InputData=data, **settings)
    opacity = vtk.vtkPiecewiseFunction()
    colour = vtk.vtkColorTransferFunction()
    low, high = data.GetScalarRange()
    for share, value in ((0, 0), (0.6, 0.1), (1, 0.8)):
        opacity.AddPoint(low + share * (high - low), value)
        colour.AddRGBPoint(low + share * (high - low), 1, share, 1 - share)
    looks = make("vtkVolumeProperty", ScalarOpacity=opacity, Color=colour,
                 InterpolationType=vtk.VTK_LINEAR_INTERPOLATION, ScalarOpacityUnitDistance=0.3)
    volume = make("vtkVolume", Mapper=mapper, Property=looks)
    stage.renderer.AddVolume(volume)
    return volume


@row
def volumes(stage):
    add_volume(stage, AutoAdjustSampleDistances=False, UseJittering=False)


@row
def volumes_with_shade(stage):
    add_volume(stage, AutoAdjustSampleDistances=False, UseJittering=False).GetProperty().ShadeOn()


@row
def volumes_on_the_cpu(stage):
    add_volume(stage, "vtkFixedPointVolumeRayCastMapper", AutoAdjustSampleDistances=False,
               NumberOfThreads=1)


@row
def multi_volumes(stage):
    add_volume(stage, AutoAdjustSampleDistances=False, UseJittering=False)
    add_volume(stage, AutoAdjustSampleDistances=False, UseJittering=False).SetPosition(2, 0, 0)


@row
def volumes_behind_translucent(stage):
    volumes(stage)
    translucent(stage)


@row
def image_slices(stage):
    mapper = vtk.vtkImageSliceMapper()
    mapper.SetInputData(picture_of(3))
    slice_ = make("vtkImageSlice", Mapper=mapper, Scale=(0.1, 0.1, 0.1), Position=(-2.4, -2.0, 0.3))
    slice_.RotateX(60)
    stage.renderer.AddViewProp(slice_)


@row
def image_actors(stage):
    actor = make("vtkImageActor", InputData=picture_of(4), Scale=(0.1, 0.1, 0.1),
                 Position=(-1.4, -2.0, 0.3))
    actor.RotateX(60)
    stage.renderer.AddActor(actor)


@row
def image_stacks(stage):
    stack = vtk.vtkImageStack()
    for layer in range(2):
        mapper = vtk.vtkImageSliceMapper()
        mapper.SetInputData(picture_of(3))
        part = make("vtkImageSlice", Mapper=mapper, Scale=(0.1, 0.1, 0.1),
                    Position=(-2.4 + layer, -2.0, 0.3))
        part.GetProperty().SetOpacity(0.7)
        part.GetProperty().SetLayerNumber(layer)
        stack.AddImage(part)
    stage.renderer.AddViewProp(stack)


@row
def hidden_props(stage):
    stage.ball.VisibilityOff()


@row
def props_that_neither_cast_nor_receive(stage):
    from rtwshadows import vtkAdaptiveShadowMapPass
    for prop in (stage.ball, stage.floor):
        keys = vtk.vtkInformation()
        keys.Set(vtkAdaptiveShadowMapPass.CASTS_SHADOW(), 0)
        keys.Set(vtkAdaptiveShadowMapPass.RECEIVES_SHADOW(), 0)
        prop.SetPropertyKeys(keys)


@row
def many_silhouettes(stage):
    """Edges before edges, where depths that are known too early would leave holes."""
    for i in range(60):
        x, y = (i * 0.37) % 6 - 3, (i * 0.61) % 5 - 3
        stage.add(box((x, y, 0.5 + (i % 7) * 0.1), (0.07, 0.07, 1)), (1, 1 - i / 60, i / 60))
        actor = stage.add(ball((x, y + 0.2, 1.2), 0.13, 9), (i / 60, 1, 0.5))
        actor.RotateZ(i)


@row
def far_from_the_origin(stage):
    for actor in (stage.floor, stage.ball, stage.box, stage.pole):
        actor.SetPosition(1e4, 2e4, 0)
    stage.renderer.GetActiveCamera().SetFocalPoint(1e4, 2e4, 0.4)
    stage.renderer.GetActiveCamera().SetPosition(1e4 - 1.5, 2e4 - 7.5, 5)
    stage.renderer.ResetCameraClippingRange()


@row
def parallel_projection(stage):
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.renderer.GetActiveCamera().SetParallelScale(3)


@row
def off_axis_cameras(stage):
    camera = stage.renderer.GetActiveCamera()
    camera.SetWindowCenter(0.3, -0.2)
    camera.SetUseHorizontalViewAngle(1)
    camera.SetModelTransformMatrix((1, 0, 0, 0.2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1))


@row
def sheared_cameras(stage):
    stage.renderer.GetActiveCamera().SetViewShear(0.1, 0.2, 1)


@row
def several_lights(stage):
    stage.renderer.AddLight(make("vtkLight", Switch=0, Position=(1, 0, 5)))
    lamp = make("vtkLight", Positional=1, ConeAngle=40, Position=(-3, -3, 5), FocalPoint=(0, 0, 0),
                Color=(1, 0.6, 0.4), Intensity=0.6, Exponent=2)
    stage.renderer.AddLight(lamp)
    stage.renderer.AddLight(make("vtkLight", LightType=vtk.VTK_LIGHT_TYPE_HEADLIGHT, Intensity=0.3))
    stage.renderer.AddLight(make("vtkLight", Positional=1, ConeAngle=90, Position=(0, -4, 2),
                                 Intensity=0.3, AttenuationValues=(1, 0.1, 0)))


@row
def light_kit(stage):
    stage.renderer.RemoveAllLights()
    kit = vtk.vtkLightKit()
    kit.AddLightsToRenderer(stage.renderer)
    stage.kept.append(kit)
