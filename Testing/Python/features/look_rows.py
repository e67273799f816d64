# SPDX-License-Identifier: BSD-3-Clause
"""Features of how a surface looks: representations, textures, materials, scalars, translucency."""

from .stage import ball, box, fed, floor, make, mapper_of, row, vtk


@row
def nothing_else(stage):
    pass


@row
def edges(stage):
    for actor in (stage.ball, stage.box):
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0, 0, 0)


@row
def vertices(stage):
    looks = stage.ball.GetProperty()
    looks.VertexVisibilityOn()
    looks.SetPointSize(4)
    looks.SetVertexColor(0, 0, 1)


@row
def wireframe(stage):
    stage.ball.GetProperty().SetRepresentationToWireframe()
    stage.box.GetProperty().SetRepresentationToWireframe()
    stage.box.GetProperty().SetLineWidth(3)


@row
def points(stage):
    stage.ball.GetProperty().SetRepresentationToPoints()
    stage.ball.GetProperty().SetPointSize(5)


@row
def points_as_spheres(stage):
    points(stage)
    stage.ball.GetProperty().RenderPointsAsSpheresOn()


@row
def lines(stage):
    line = make("vtkLineSource", Point1=(-3, -1, 0.5), Point2=(3, -1, 1.5))
    stage.add(line, (1, 1, 0), LineWidth=5)
    stage.add(make("vtkOutlineSource", Bounds=(-2, 2, -2, 2, 0, 2)), (1, 0, 1))


@row
def lines_as_tubes(stage):
    line = make("vtkLineSource", Point1=(-3, -1, 0.5), Point2=(3, -1, 1.5))
    stage.add(line, (1, 1, 0), LineWidth=7).GetProperty().RenderLinesAsTubesOn()


def picture_of(channels, size=16):
    """A chequered image whose fourth channel, where there is one, cuts holes."""
    image = make("vtkImageData", Dimensions=(size, size, 1))
    image.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, channels)
    for j in range(size):
        for i in range(size):
            light = 255 if (i // 2 + j // 2) % 2 else 90
            for channel in range(3):
                image.SetScalarComponentFromDouble(i, j, 0, channel, light - 20 * channel)
            if channels == 4:
                image.SetScalarComponentFromDouble(i, j, 0, 3, 255 if (i // 4 + j // 4) % 2 else 0)
    return image


def texture_of(channels):
    return make("vtkTexture", InputData=picture_of(channels))


@row
def textures(stage):
    stage.floor.SetTexture(texture_of(3))


@row
def opacity_textures(stage):
    fence = make("vtkPlaneSource", Origin=(-3, -1.5, 0), Point1=(1, -1.5, 0), Point2=(-3, -1.5, 2))
    stage.add(fence).SetTexture(texture_of(4))


@row
def opacity_textures_that_are_opaque(stage):
    opacity_textures(stage)
    stage.renderer.GetActors().GetLastActor().ForceOpaqueOn()


@row
def clipping(stage):
    for actor in (stage.ball, stage.box):
        actor.GetMapper().AddClippingPlane(make("vtkPlane", Origin=(0.4, 0, 1), Normal=(-1, 1, 0.2)))


@row
def clipped_capped_by_filter(stage):
    clip = make("vtkClipPolyData", ClipFunction=make("vtkPlane", Origin=(0.5, 0, 1)))
    fed(clip, ball((0.5, 0, 1.2)))
    stage.ball.SetMapper(mapper_of(clip))


@row
def back_faces_culled(stage):
    clipped_capped_by_filter(stage)
    stage.ball.GetProperty().BackfaceCullingOn()
    stage.box.GetProperty().FrontfaceCullingOn()


@row
def back_faces_of_their_own(stage):
    clipped_capped_by_filter(stage)
    stage.ball.SetBackfaceProperty(make("vtkProperty", Color=(0.1, 0.8, 0.8)))


@row
def mirrored(stage):
    stage.ball.SetScale(-1, 1, 0.7)
    stage.ball.SetPosition(1, 0, 0.3)
    stage.ball.RotateZ(20)
    stage.ball.GetProperty().BackfaceCullingOn()


@row
def flat_shading(stage):
    stage.ball.GetProperty().SetInterpolationToFlat()


@row
def physically_based(stage):
    for actor in (stage.floor, stage.ball, stage.box):
        actor.GetProperty().SetInterpolationToPBR()
        actor.GetProperty().SetRoughness(0.3)
        actor.GetProperty().SetMetallic(0.4)


@row
def gloss(stage):
    for actor in (stage.floor, stage.ball):
        actor.GetProperty().SetSpecular(0.8)
        actor.GetProperty().SetSpecularPower(8)


@row
def unlit(stage):
    stage.floor.GetProperty().LightingOff()
    stage.ball.GetProperty().LightingOff()


@row
def scalars(stage):
    elevation = make("vtkElevationFilter", LowPoint=(0, 0, 0), HighPoint=(0, 0, 2))
    fed(elevation, ball((0.5, 0, 1.2)))
    stage.ball.SetMapper(mapper_of(elevation, ScalarRange=(0, 1)))


@row
def interpolated_scalars(stage):
    scalars(stage)
    stage.ball.GetMapper().InterpolateScalarsBeforeMappingOn()


@row
def cell_scalars(stage):
    source = box((-1.8, 0.6, 1), (1, 1, 2))
    source.Update()
    values = make("vtkFloatArray", NumberOfTuples=6)
    for i in range(6):
        values.SetValue(i, i / 5)
    mesh = source.GetOutput()
    mesh.GetCellData().SetScalars(values)
    stage.box.SetMapper(make("vtkPolyDataMapper", InputData=mesh))


@row
def translucent_scalars(stage):
    scalars(stage)
    table = make("vtkLookupTable", AlphaRange=(0.2, 1))
    table.Build()
    stage.ball.GetMapper().SetLookupTable(table)


@row
def translucent(stage):
    stage.add(ball((-0.4, -1.6, 0.9), 0.8), (0.2, 0.9, 0.9), Opacity=0.5)
    stage.add(ball((0.5, -2.0, 0.8), 0.7), (0.9, 0.9, 0.1), Opacity=0.4)


@row
def translucent_forced_opaque(stage):
    translucent(stage)
    stage.renderer.GetActors().GetLastActor().ForceOpaqueOn()


@row
def opaque_forced_translucent(stage):
    stage.ball.ForceTranslucentOn()


@row
def coincident_polygons(stage):
    patch = stage.add(floor(1.5, 0), (0.9, 0.2, 0.2))
    patch.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2)
    patch.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    stage.undo = lambda: patch.GetMapper().SetResolveCoincidentTopologyToDefault()


@row
def coplanar_actors(stage):
    stage.add(floor(1.5, 0), (0.9, 0.2, 0.2))
